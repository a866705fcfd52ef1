"""/usr/bin/python3 kconfig.py MODULE_KCONFIG PRJ_CONF OUTPUT

Reads the Kconfig file here, which takes the module's in, and the settings of prj.conf, and writes
.config. As Zephyr's script does, it fails on any warning and on any setting that has no effect.
"""

import os
import sys

import kconfiglib


def main():
    module, settings, output = sys.argv[1:]
    os.environ["MODULE_KCONFIG"] = module
    kconf = kconfiglib.Kconfig(os.path.join(os.path.dirname(__file__), "Kconfig"), warn_to_stderr=False)
    kconf.load_config(settings)
    problems = list(kconf.warnings)
    for symbol in kconf.unique_defined_syms:
        wanted = symbol.user_value
        if wanted is None:
            continue
        if symbol.type == kconfiglib.BOOL:
            wanted = kconfiglib.TRI_TO_STR[wanted]
        if wanted != symbol.str_value:
            problems.append(f"{symbol.name} was assigned {wanted} but is {symbol.str_value}: "
                            + kconfiglib.expr_str(symbol.direct_dep))
    if problems:
        sys.exit("\n".join(problems))
    kconf.write_config(output)


main()
