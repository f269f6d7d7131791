package org.robotui.uic.parameters.internal.model;

import java.util.Optional;

/**
 * What is known of the value of a parameter.
 *
 * @param value the value, none where it is not known or not set
 * @param first the value when it was first read, none before
 * @param problem why it could not be read or set, none where all is well
 * @param busy whether it is being set now
 * @param readAt when it was read, {@link System#nanoTime()}
 * @param text the value in one line, cut where it is long; made once, since a value may have megabytes
 */
record Held(Optional<Object> value, Optional<Object> first, Optional<String> problem, boolean busy, long readAt,
    String text) {
  private static final int LONGEST = 2000;

  static final Held NOTHING = new Held(Optional.empty(), Optional.empty(), Optional.empty(), false, 0, "");

  static Held read(Optional<Held> before, Optional<Object> value, long now) {
    Optional<Object> first = before.flatMap(Held::first).or(() -> value);
    // What went wrong at setting stays to be read until the value changes.
    Optional<String> problem = before.filter(b -> b.value().equals(value)).flatMap(Held::problem);
    Optional<Held> same = before.filter(b -> b.value().equals(value));
    return new Held(value, first, problem, before.filter(Held::busy).isPresent(), now,
        same.map(Held::text).orElseGet(() -> value.map(Held::line).orElse("")));
  }

  Held wrong(String why, long now) {
    return new Held(value, first, Optional.of(why), false, now, text);
  }

  Held setting() {
    return new Held(value, first, Optional.empty(), true, readAt, text);
  }

  Held set(Object to, long now) {
    return new Held(Optional.of(to), first, Optional.empty(), false, now, line(to));
  }

  Held expired(long old) {
    return new Held(value, first, Optional.empty(), busy, old, text);
  }

  static String line(Object value) {
    String text = ValueText.of(value);
    return text.length() > LONGEST ? text.substring(0, LONGEST) + "\u2026" : text;
  }

  boolean changed() {
    return first.isPresent() && !first.equals(value);
  }
}
