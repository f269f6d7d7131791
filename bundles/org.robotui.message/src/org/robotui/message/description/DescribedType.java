package org.robotui.message.description;

import java.util.Map;
import java.util.Objects;

/**
 * What a node says of a type.
 *
 * @param description the type with all it refers to
 * @param sources texts of {@code .msg} files by the name of three parts, which hold the constants that descriptions
 * lack; may be empty
 */
public record DescribedType(TypeDescription description, Map<String, String> sources) {

  /** Copies the texts. */
  public DescribedType {
    Objects.requireNonNull(description, "description");
    sources = Map.copyOf(sources);
  }
}
