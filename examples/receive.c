/* A receiver in C: streams of polygons or slices from standard input, scan after scan. It joins
 * loose fragments. With a number as its argument it receives the surface on that channel. */
#include <discmc/discmc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIME_STAMP = 1 }; /* see slices.c */

static uint8_t receiver_memory[DISCMC_RECEIVER_BYTES(256, 256, 4) + 256 * 1024];
static uint8_t joiner_memory[DISCMC_JOINER_BYTES(10000)];
static discmc_receiver* receiver;
static discmc_joiner* joiner;
static uint8_t channel = DISCMC_ANY_CHANNEL;

/* What arrived of a scan. */
static unsigned regions, corners, lost_rows, milliseconds;
static int32_t min_z;
static int has_finish;

static discmc_sink_result accept(void* context, const discmc_event* event) {
  static uint8_t incidence;
  static discmc_vertex corner;
  (void)context;
  switch (event->kind) {
    case DISCMC_REGION:
      incidence = event->incidence;
      ++regions;
      break;
    case DISCMC_RING:
      corner = event->start;
      break;
    case DISCMC_RUN: { /* from this corner to the next */
      const discmc_vertex run = discmc_run_vector(incidence, event->run);
      ++corners;
      if (corner.z < min_z) min_z = corner.z;
      corner.x += run.x;
      corner.y += run.y;
      corner.z += run.z;
      break;
    }
    case DISCMC_SKIPPED:
      ++lost_rows;
      break;
    case DISCMC_APPLICATION: {
      const discmc_application_record* const record = event->of.application;
      if (record->kind == TIME_STAMP && record->count == 2)
        milliseconds = record->bytes[0] + 256U * record->bytes[1];
      break;
    }
    case DISCMC_FINISH:
      has_finish = 1;
      break;
    default:
      break;
  }
  return DISCMC_SINK_ACCEPTED;
}

/* Before every scan. The joiner stays where it is, so the receiver keeps its sink. */
static discmc_status begin_scan(void) {
  const discmc_joiner_config joining = {
      .order = DISCMC_SWEEP_ORDER,
      .memory = {joiner_memory, sizeof joiner_memory},
      .sink = {NULL, accept},
  };
  regions = corners = lost_rows = milliseconds = 0;
  min_z = INT32_MAX;
  has_finish = 0;
  return discmc_joiner_start(&joiner, &joining);
}

static discmc_status start(void) {
  const discmc_status status = begin_scan();
  const discmc_receiver_config receiving = {
      .channel = channel,
      .memory = {receiver_memory, sizeof receiver_memory},
      .sink = {joiner, discmc_joiner_accept},
  };
  return status == DISCMC_OK ? discmc_receiver_start(&receiver, &receiving) : status;
}

static void print_scan(void) {
  const discmc_receiver_info info = discmc_receiver_get_info(receiver);
  printf("scan %u, %s: %u regions, %u corners, from z %.1f", info.header.scan,
         info.holds_slices ? "slices" : "polygons", regions, corners, (double)min_z / 2);
  if (info.is_complete && has_finish) printf("; complete");
  if (lost_rows > 0) printf("; %u rows lost", lost_rows);
  if (milliseconds > 0) printf("; at %u ms", milliseconds);
  printf("\n");
}

static discmc_status push(const uint8_t* bytes, size_t count) {
  for (;;) {
    const discmc_push_result result = discmc_receiver_push(receiver, bytes, count);
    discmc_status status = result.status;
    bytes += result.accepted;
    count -= result.accepted;
    if (status == DISCMC_FINISHED) { /* the remaining bytes are of the next scan */
      while ((status = discmc_joiner_finish(joiner)) == DISCMC_SUSPENDED) continue;
      print_scan();
      if (status == DISCMC_OK) status = begin_scan();
      if (status == DISCMC_OK && count > 0) continue;
    }
    if (status != DISCMC_SUSPENDED) return status; /* suspended: rows are skipped */
  }
}

int main(int count, char** arguments) {
  uint8_t bytes[256];
  size_t read;
  discmc_status status;
  if (count > 1) channel = (uint8_t)atoi(arguments[1]);
  status = start();
  while (status == DISCMC_OK && (read = fread(bytes, 1, sizeof bytes, stdin)) > 0)
    status = push(bytes, read);
  if (status != DISCMC_OK) fprintf(stderr, "%s\n", discmc_status_string(status));
  return status == DISCMC_OK ? 0 : 1;
}
