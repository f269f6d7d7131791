package org.robotui.lcm.type;

import java.util.List;

/** A type as a {@code .lcm} file declares it. */
public sealed interface TypeDefinition {

  /**
   * The full name.
   *
   * @return package and name with dots; only the name where the file has no package
   */
  String name();

  /**
   * The constants.
   *
   * @return in the order of the file
   */
  List<ConstantDefinition> constants();

  /**
   * Where the type is declared.
   *
   * @return the place of its name
   */
  Place place();

  /**
   * A message type, or a part of others.
   *
   * @param name the full name
   * @param members what is sent, in order
   * @param constants named values
   * @param place where it is declared
   */
  record Struct(String name, List<MemberDefinition> members, List<ConstantDefinition> constants, Place place)
      implements TypeDefinition {

    /** Copies the lists. */
    public Struct {
      members = List.copyOf(members);
      constants = List.copyOf(constants);
    }
  }

  /**
   * An enumeration, sent as {@code int32_t}. The type language does not describe them any more, old files have them.
   *
   * @param name the full name
   * @param constants the values, as {@code int32_t}
   * @param place where it is declared
   */
  record Enumeration(String name, List<ConstantDefinition> constants, Place place) implements TypeDefinition {

    /** Copies the list. */
    public Enumeration {
      constants = List.copyOf(constants);
    }
  }
}
