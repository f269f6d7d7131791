package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Browser.Kind;

/** Why something cannot be done with a thing, as users read it. Pure. */
final class Obstacles {
  private static final List<String> TRANSFORMS = List.of("tf", "tf_static");

  private Obstacles() {}

  /** Why a topic has no stream. */
  static String echo(Key key, Optional<Entry> entry, Optional<Described> described) {
    if (key.kind() != Kind.TOPIC) {
      return "Only topics carry messages.";
    }
    if (entry.isEmpty()) {
      return key.robot() + " has no such topic any more.";
    }
    if (entry.get().stream().isPresent()) {
      return "";
    }
    String end = key.name().substring(key.name().lastIndexOf('/') + 1);
    if (TRANSFORMS.contains(end)) {
      return key.robot() + " takes transforms as frames, for the views that draw; it offers no stream of them.";
    }
    boolean silent = described.filter(d -> d.key().equals(key)).flatMap(Described::description)
        .map(d -> Facts.counts(Kind.TOPIC, d.facts())).filter(c -> c.publishers().orElse(1) == 0).isPresent();
    return silent ? "Nobody publishes it."
        : key.robot()
            + " offers no stream of it: it only takes it as a command, it lies outside of its namespace, or its configuration leaves it out.";
  }

  /** Why no message can be said on a topic, empty where one can be. */
  static String publish(Described described, Speaker speaker) {
    Key key = described.key();
    if (key.kind() != Kind.TOPIC) {
      return "Messages can be published on topics only.";
    }
    if (described.description().isEmpty()) {
      return described.failure().map(why -> key.robot() + " does not answer: " + why)
          .orElse("Asking " + key.robot() + "\u2026");
    }
    if (described.description().get().shape().isEmpty()) {
      return "The definition of its type is not known: "
          + Optional.ofNullable(described.description().get().facts().get("definition"))
              .orElse("there is no definition of " + (described.type().isEmpty() ? "its type" : described.type()));
    }
    return speaker.obstacle(key.robot()).map(why -> "Nothing can be published here: " + why).orElse("");
  }
}
