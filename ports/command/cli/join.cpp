// discmc join: joins the streams of slabs to the stream of the volume.
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "commands.hpp"
#include "files/output_file.hpp"
#include "files/write_failure.hpp"
#include "require.hpp"
#include "stream_input.hpp"
#include "streams/slab_ranges.hpp"
#include "streams/spilling_joiner.hpp"
#include "streams/stream_output.hpp"
#include "summary.hpp"
#include "surface_receiver.hpp"
#include "text/message.hpp"

namespace discmc::command {
namespace {

std::string described(const StreamHeader& header) {
  std::ostringstream text;
  text << header.width << "x" << header.height << "x" << header.depth << " voxels of "
       << header.spacing_nm[0] / 1e6 << "," << header.spacing_nm[1] / 1e6 << ","
       << header.spacing_nm[2] / 1e6 << " mm at threshold " << header.thresholds[0]
       << (header.border == Border::open ? ", border open" : "");
  return text.str();
}

// Whether two surfaces can meet. The scan number may differ, as each device counts its own scans.
bool is_same_volume(const StreamHeader& a, const StreamHeader& b) {
  return a.width == b.width && a.height == b.height && a.depth == b.depth &&
         a.thresholds[0] == b.thresholds[0] && a.border == b.border &&
         std::equal(a.spacing_nm, a.spacing_nm + 3, b.spacing_nm);
}

// Joins the events of all streams, read one after another, into one stream.
class Join {
 public:
  /// memory: for waiting pieces. Units: bytes.
  Join(std::ostream& out, std::uint64_t memory)
      : output_(&out), joiner_(make_sink(encoded_), memory) {}

  /// Throws std::runtime_error if the streams do not belong together.
  int add(const std::string& path) {
    path_ = path;
    is_begun_ = has_range_ = false;
    StreamReader reader(make_sink(*this));
    reader.set_packet_passthrough({&encoded_, [](void* encoded, const RecordsPacket& packet) {
                                     static_cast<Encoded*>(encoded)->append(packet);
                                   }});
    read_file(path, reader);
    require_one_surface(path, reader);
    if (is_begun_ && !has_range_ && depth_ > 0) add_whole();
    return completeness(path, reader.report());
  }
  /// Limit: after the last stream.
  void finish() {
    if (!slabs_.missing().empty())
      for (const SlabRange& range : slabs_.ranges()) write_slab(range, encoder_);
    joiner_.finish();
    (void)encoder_.flush();  // a file accepts all; commit() reports a failed write
  }

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) begin(*event.header);
    if (event.kind != Event::Kind::application) return joiner_.accept(event);
    SlabRange range;
    Placement placement;
    if (read_slab_range(*event.application, range)) {
      add_range(range);
    } else if (!read_placement(*event.application, placement) || is_first_) {
      return joiner_.accept(event);  // all placements are equal; only the first is written
    }
    return SinkResult::accepted;
  }

  const SlabRanges& slabs() const { return slabs_; }
  // Returns the number of regions written.
  std::uint64_t regions() const { return encoded_.regions; }
  std::uint64_t fragments() const { return encoded_.fragments; }

 private:
  // Accepts what the joiner emits, and pieces that need no joining. Counts them here, as a
  // truncated stream has no totals.
  struct Encoded {
    Encoder& encoder;
    std::uint64_t regions = 0;
    std::uint64_t fragments = 0;
    SinkResult accept(const Event& event) {
      const SinkResult answer = encoder.accept(event);
      if (answer != SinkResult::accepted) return answer;
      if (event.kind == Event::Kind::region_end) ++regions;
      if (event.kind == Event::Kind::fragment_end) ++fragments;
      return answer;
    }
    void append(const RecordsPacket& packet) {
      require(encoder.append(packet));
      regions += packet.pieces;
    }
  };

  void begin(const StreamHeader& header) {
    if (is_begun_) return;  // headers are repeated
    is_begun_ = true;
    is_first_ = first_path_.empty();
    if (is_first_) {
      header_ = header;
      depth_ = header.depth;
      first_path_ = path_;
      encoder_.encode_normals();
      require(encoder_.start(header.label(), output_.byte_output()));
    } else if (!is_same_volume(header, header_)) {
      throw std::runtime_error("this slab has " + described(header) + ", and " + first_path_ +
                               " has " + described(header_) + "; give the slabs of one volume");
    }
  }

  // A stream without a range covers the whole volume.
  void add_whole() {
    try {
      add_range({0, depth_, depth_});
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_ + ": " + error.what());
    }
  }

  // read_file() adds the file's name to an exception thrown while it reads.
  void add_range(const SlabRange& range) {
    has_range_ = true;
    if (depth_ == 0) depth_ = range.depth;
    if (range.depth != depth_)
      throw std::runtime_error("its slab is part of " + std::to_string(range.depth) +
                               " slices, and the volume has " + std::to_string(depth_) +
                               "; extract the slab again");
    if (const auto twice = slabs_.add(range))
      throw std::runtime_error("the " + text({*twice}) + " are given twice; give every slab once");
  }

  StreamOutput output_;
  Encoder encoder_;
  Encoded encoded_{encoder_};
  SpillingJoiner joiner_;
  SlabRanges slabs_;
  std::uint32_t depth_ = 0;  // of the volume; if headers lack it, of the first range
  StreamHeader header_;
  std::string first_path_;
  // The stream that is being read.
  std::string path_;
  bool is_first_ = false;
  bool is_begun_ = false;
  bool has_range_ = false;
};

}  // namespace

int run_join(const JoinArguments& arguments) {
  OutputFile file(arguments.output);
  Join join(file.stream(), arguments.memory);
  int code = exit_ok;
  for (const std::string& stream : arguments.streams) code = std::max(code, join.add(stream));
  join.finish();
  file.commit();
  const std::vector<SlabRange> missing = join.slabs().missing();
  if (!missing.empty()) {
    print_message(arguments.output == "-" ? "standard output" : arguments.output,
                  "the " + text(missing) + " are missing, so " + std::to_string(join.fragments()) +
                      " loose fragments have no partner; join the slabs of these slices, too");
    code = exit_incomplete;
  }
  if (arguments.is_quiet) return code;
  std::ostream& out = table_stream(arguments.output);
  print_file(arguments.output, out);
  out << join.regions() << " polygons\n";
  require_written(out);
  return code;
}

}  // namespace discmc::command
