package org.robotui.core.internal.config.model;

import java.util.List;
import java.util.Optional;

/** The sections of a configuration as they stand in a text, with what templates have formed. */
public interface WrittenText {
  /**
   * A section.
   *
   * @param path the names that lead there
   * @return what is written there; a component of one word says its type; none where nothing is written there
   */
  Optional<RawSection> at(List<String> path);

  /**
   * Where something stands.
   *
   * @param path the names that lead there
   * @return the line from 1 of what stands there, else of the nearest section around it that is there
   */
  int line(List<String> path);
}
