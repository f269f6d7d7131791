package org.robotui.uic.topics.internal.model;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.api.port.Browser.Kind;

/**
 * What the user wants to see.
 *
 * @param section the kind that is listed
 * @param filter words that listed things contain
 * @param selected what is described
 * @param echoed the topic whose messages are shown
 * @param listed the topic of a recording all of whose messages are shown
 * @param measured the topics that are measured
 * @param paused whether the echo is held
 * @param pinned the message that is shown in place of the newest
 */
public record Wishes(
    Kind section,
    String filter,
    Optional<Key> selected,
    Optional<Key> echoed,
    Optional<Key> listed,
    Set<Key> measured,
    boolean paused,
    OptionalLong pinned) {
  /** At the beginning: the topics, and nothing is asked for. */
  public static final Wishes FIRST =
      new Wishes(Kind.TOPIC, "", Optional.empty(), Optional.empty(), Optional.empty(), Set.of(), false,
          OptionalLong.empty());

  /** What a robot is asked for while nobody sees it: nothing. */
  Wishes quiet() {
    return new Wishes(section, filter, selected, Optional.empty(), Optional.empty(), Set.of(), paused, pinned);
  }

  Wishes section(Kind kind) {
    return new Wishes(kind, filter, selected, echoed, listed, measured, paused, pinned);
  }

  Wishes filter(String words) {
    return new Wishes(section, words, selected, echoed, listed, measured, paused, pinned);
  }

  Wishes select(Optional<Key> key) {
    return new Wishes(section, filter, key, echoed, listed, measured, paused, pinned);
  }

  Wishes echo(Optional<Key> key) {
    boolean same = key.equals(echoed);
    return new Wishes(section, filter, selected, key, listed, measured, same && paused,
        same ? pinned : OptionalLong.empty());
  }

  Wishes list(Optional<Key> key) {
    return new Wishes(section, filter, selected, echoed, key, measured, paused, pinned);
  }

  Wishes measure(Set<Key> keys) {
    return new Wishes(section, filter, selected, echoed, listed, Set.copyOf(keys), paused, pinned);
  }

  Wishes pause(boolean held, OptionalLong number) {
    return new Wishes(section, filter, selected, echoed, listed, measured, held, number);
  }
}
