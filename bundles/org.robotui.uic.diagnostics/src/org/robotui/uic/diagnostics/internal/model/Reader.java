package org.robotui.uic.diagnostics.internal.model;

import java.util.Optional;

/**
 * Reads the state of lines at the moment looked at: now, or in a slot of the past.
 *
 * @param now monotonic time
 * @param staleNanos after how long without a report a part is stale
 * @param slot the slot looked at; none for now
 * @param slotNanos how long a slot is
 */
record Reader(long now, long staleNanos, Optional<Long> slot, long slotNanos) {
  private static final double NANOS = 1e-9;

  Level level(Node node) {
    return slot.map(s -> node.timeline().level(s)).orElseGet(node::level);
  }

  Optional<Moment> moment(Node node) {
    return node.part()
        .flatMap(part -> slot.map(s -> part.at(s * slotNanos, (s + 1) * slotNanos - 1)).orElseGet(part::newest));
  }

  /**
   * The message of a line; of one that is silent, for how long it has been so; of a group that says nothing, how many
   * are not OK.
   */
  String message(Node node) {
    String own = own(node);
    return own.isBlank() && !node.children().isEmpty() ? below(node) : own;
  }

  private String own(Node node) {
    String said = moment(node).map(Moment::message).orElse("");
    if (slot.isPresent()) {
      return node.part().isPresent() && moment(node).isEmpty() ? "what it said then is no longer kept" : said;
    }
    return node.part().filter(part -> part.silent(now, staleNanos))
        .map(part -> "no report for " + seconds(now - part.receivedNanos())
            + (said.isBlank() ? "" : ", the last was: " + said))
        .orElse(said);
  }

  /** When a part said what is shown. */
  String told(Node node) {
    if (node.part().isEmpty()) {
      return "";
    }
    if (slot.isPresent()) {
      return moment(node).map(m -> "said " + seconds(now - m.nanos()) + " ago").orElse("no longer kept");
    }
    return "reported " + seconds(now - node.part().get().receivedNanos()) + " ago";
  }

  private String below(Node node) {
    int[] counts = {0, 0};
    count(node, counts);
    return counts[0] == 0 ? counts[1] + (counts[1] == 1 ? " part" : " parts")
        : counts[0] + " of " + counts[1] + " not OK";
  }

  private void count(Node node, int[] counts) {
    for (Node child : node.children()) {
      if (child.children().isEmpty()) {
        counts[0] += level(child).problem() ? 1 : 0;
        counts[1]++;
      }
      count(child, counts);
    }
  }

  private static String seconds(long nanos) {
    return org.robotui.ui.Figures.ageOfValue(nanos * NANOS);
  }
}
