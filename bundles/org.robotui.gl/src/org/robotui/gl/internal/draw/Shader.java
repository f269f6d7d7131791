package org.robotui.gl.internal.draw;

import java.util.EnumSet;
import java.util.Set;

/**
 * A variant of a pair of shaders.
 *
 * @param name of the two files, without their endings
 * @param traits what it does besides
 */
record Shader(String name, Set<Trait> traits) {
  /** What a variant does; names of definitions in the files. */
  enum Trait {
    /** Writes part and element in place of a colour. */
    PICK,
    /** Sizes are metres. */
    METRES,
    /** Points are round. */
    DISC,
    /** Light falls on it. */
    LIT,
    /** Each triangle is flat. */
    FACETS,
    /** A picture is on it. */
    TEXTURED,
    /** One mesh many times. */
    INSTANCED
  }

  static Shader of(String name, Trait... traits) {
    EnumSet<Trait> all = EnumSet.noneOf(Trait.class);
    all.addAll(Set.of(traits));
    return new Shader(name, Set.copyOf(all));
  }

  Shader with(Trait trait) {
    EnumSet<Trait> all = EnumSet.of(trait);
    all.addAll(traits);
    return new Shader(name, Set.copyOf(all));
  }

  Shader with(Trait trait, boolean wanted) {
    return wanted ? with(trait) : this;
  }
}
