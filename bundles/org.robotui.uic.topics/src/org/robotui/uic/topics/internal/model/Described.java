package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Browser.Description;

/**
 * What a robot said about the selected thing.
 *
 * @param key the thing
 * @param description what is known, none before the first answer
 * @param facts its facts as lines
 * @param failure why the robot did not answer, where it did not
 */
public record Described(Key key, Optional<Description> description, List<Fact> facts, Optional<String> failure) {
  static Described asking(Key key) {
    return new Described(key, Optional.empty(), List.of(), Optional.empty());
  }

  /** The name of its type, where the description knows it. */
  public String type() {
    return description.map(d -> d.item().type()).orElse("");
  }
}
