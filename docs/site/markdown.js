// Markdown as a code host reads it: the same anchors, the same links.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../ports/web/', import.meta.url));
const MarkdownIt = require('markdown-it');

const markdown = new MarkdownIt({ html: true });
markdown.renderer.rules.table_open = () => '<div class="wide"><table>\n';
markdown.renderer.rules.table_close = () => '</table></div>\n';

const textOf = (inline) =>
  inline.children.map(({ type, content }) => (type === 'image' ? '' : content)).join('');

/** The anchor of a heading: its letters, digits, `-` and `_` in lower case, and `-` for a space. */
const anchorOf = (heading) =>
  heading.toLowerCase().replace(/[^\p{L}\p{N}\-_ ]/gu, '').replaceAll(' ', '-');

/**
 * A page of a Markdown file. The function rewrite(href) returns where a link leads.
 * @returns {{title: string, headings: {anchor: string, text: string}[], body: string}}
 *   headings: those of the second level
 */
export function pageOf(text, rewrite) {
  const tokens = markdown.parse(text, {});
  const seen = new Map();
  const headings = [];
  let title = '';
  tokens.forEach((token, i) => {
    if (token.type === 'heading_open') {
      const heading = textOf(tokens[i + 1]);
      const anchor = anchorOf(heading);
      const times = seen.get(anchor) ?? 0;
      seen.set(anchor, times + 1);
      token.attrSet('id', times ? `${anchor}-${times}` : anchor);
      if (token.tag === 'h1') title ||= heading;
      if (token.tag === 'h2') headings.push({ anchor: token.attrGet('id'), text: heading });
    }
    for (const child of token.children ?? []) {
      const name = { link_open: 'href', image: 'src' }[child.type];
      if (name) child.attrSet(name, rewrite(child.attrGet(name)));
    }
  });
  return { title, headings, body: markdown.renderer.render(tokens, markdown.options, {}) };
}

/** The links of a Markdown file, in their order. @returns {{href: string, text: string}[]} */
export function linksOf(text) {
  const links = [];
  for (const { children } of markdown.parse(text, {}))
    children?.forEach((child, i) => {
      if (child.type === 'link_open')
        links.push({ href: child.attrGet('href'), text: children[i + 1].content });
    });
  return links;
}
