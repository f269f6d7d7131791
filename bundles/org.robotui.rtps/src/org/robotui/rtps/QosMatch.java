package org.robotui.rtps;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Says why a writer and a reader do not match. */
final class QosMatch {

  private final Qos offered;

  private final Qos requested;

  private final List<String> reasons = new ArrayList<>();

  QosMatch(Qos offered, Qos requested) {
    this.offered = offered;
    this.requested = requested;
  }

  List<String> reasons() {
    atLeast(offered.reliability(), requested.reliability(), "");
    atLeast(offered.durability(), requested.durability(), "");
    atLeast(offered.liveliness(), requested.liveliness(), "liveliness ");
    atMost("a deadline of ", offered.deadline(), requested.deadline());
    atMost("a liveliness lease of ", offered.livelinessLease(), requested.livelinessLease());
    if (offered.ownership() != requested.ownership()) {
      told(words(offered.ownership()) + " ownership", words(requested.ownership()) + " ownership");
    }
    encodings();
    partitions();
    return List.copyOf(reasons);
  }

  private <E extends Enum<E>> void atLeast(E offer, E request, String what) {
    if (offer.compareTo(request) < 0) {
      told(what + words(offer), what + words(request));
    }
  }

  private void atMost(String what, Duration offer, Duration request) {
    if (offer.compareTo(request) > 0) {
      told(what + words(offer), what + words(request));
    }
  }

  private void encodings() {
    DataRepresentation used = offered.representations().getFirst();
    if (!requested.representations().contains(used)) {
      told("the encoding " + used, "one of the encodings " + requested.representations());
    }
  }

  private void partitions() {
    if (!Partitions.meet(offered.partitions(), requested.partitions())) {
      told("the partitions " + offered.partitions(), "the partitions " + requested.partitions());
    }
  }

  private void told(String offer, String request) {
    reasons.add("the writer offers " + offer + ", the reader asks for " + request);
  }

  private static String words(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  private static String words(Duration time) {
    if (Qos.infinite(time)) {
      return "any time";
    }
    return time.toMillis() + " ms";
  }
}
