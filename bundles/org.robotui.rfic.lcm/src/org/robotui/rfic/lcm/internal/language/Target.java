package org.robotui.rfic.lcm.internal.language;

import java.util.List;
import java.util.Optional;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.MemberDefinition;
import org.robotui.lcm.type.Primitive;
import org.robotui.lcm.type.TypeDefinition;
import org.robotui.lcm.type.TypeLibrary;

/**
 * What a path leads to in messages of a type.
 *
 * @param member the last member
 * @param primitive its built-in type; none for a struct
 * @param many whether it is several values
 */
public record Target(MemberDefinition member, Optional<Primitive> primitive, boolean many) {
  /**
   * Follows a path through the declaration of a type.
   *
   * @param path the path
   * @param type the type
   * @param types all types
   * @return where it leads
   * @throws IllegalArgumentException where it leads nowhere; the message names what is there
   */
  public static Target of(MemberPath path, LcmType type, TypeLibrary types) {
    TypeDefinition.Struct at = type.definition();
    boolean many = false;
    int i = 0;
    while (true) {
      MemberDefinition member = member(at, ((MemberPath.Step.Name) path.steps().get(i++)).name(), path);
      int brackets = 0;
      while (i < path.steps().size() && !(path.steps().get(i) instanceof MemberPath.Step.Name)) {
        many |= path.steps().get(i++) instanceof MemberPath.Step.All;
        brackets++;
      }
      checkBrackets(member, brackets, i == path.steps().size(), at, path);
      if (i == path.steps().size()) {
        return new Target(member, primitive(member, types), many || brackets == 0 && member.isArray());
      }
      at = struct(member, at, path, types);
    }
  }

  /** What is neither built in nor a struct is an enum, which is sent as a number. */
  private static Optional<Primitive> primitive(MemberDefinition member, TypeLibrary types) {
    return Primitive.of(member.type())
        .or(() -> types.type(member.type()).isPresent() ? Optional.empty() : Optional.of(Primitive.INT32));
  }

  private static MemberDefinition member(TypeDefinition.Struct at, String name, MemberPath path) {
    return at.members().stream().filter(m -> m.name().equals(name)).findFirst()
        .orElseThrow(() -> new IllegalArgumentException(
            at.name() + " has no member '" + name + "'"
                + (path.toString().indexOf('.') >= 0 ? " (in " + path + ")" : "") + "; it has " + names(at)));
  }

  private static List<String> names(TypeDefinition.Struct at) {
    return at.members().stream().map(m -> m.toString().substring(m.toString().indexOf(' ') + 1)).toList();
  }

  private static void checkBrackets(MemberDefinition member, int brackets, boolean last, TypeDefinition.Struct at,
      MemberPath path) {
    int dimensions = member.dimensions().size();
    boolean all = brackets == 1 && path.isMany();
    if (brackets > 0 && dimensions == 0) {
      throw new IllegalArgumentException(
          at.name() + "." + member.name() + " is declared as '" + member + "', which is no array; leave the [] away");
    }
    if (brackets == 0 && dimensions > 0 && !last) {
      throw new IllegalArgumentException(
          at.name() + "." + member.name() + " is declared as '" + member + "': write " + member.name()
              + "[] for all its elements or " + member.name() + "[0] for the first");
    }
    if (brackets > 0 && brackets != dimensions && !all) {
      throw new IllegalArgumentException(
          at.name() + "." + member.name() + " is declared as '" + member + "' and takes " + dimensions
              + " indices, not " + brackets);
    }
  }

  private static TypeDefinition.Struct struct(MemberDefinition member, TypeDefinition.Struct at, MemberPath path,
      TypeLibrary types) {
    return types.type(member.type()).map(LcmType::definition).orElseThrow(() -> new IllegalArgumentException(
        at.name() + "." + member.name() + " is declared as '" + member + "' and has no members of its own (in " + path
            + ")"));
  }

  /** Refuses what a field cannot hold. */
  void check(Field field, String path) {
    boolean text = primitive.filter(p -> p == Primitive.STRING).isPresent();
    if (primitive.isEmpty()) {
      throw new IllegalArgumentException(
          path + " is a " + member.type() + "; write which of its members '" + field.name() + "' is");
    }
    switch (field.kind()) {
      case NUMBER, FLAG, TIME -> refuse(text || many, path, field, "a number", "add an index such as [0]");
      case NUMBERS -> refuse(text, path, field, "numbers", "name another member");
      case BYTES -> refuse(text || !many, path, field, "an array", "name another member");
      case TEXT -> refuse(many, path, field, "a single value", "add an index such as [0]");
      case TEXTS -> refuse(!text, path, field, "texts", "name another member, or write the texts as a list");
    }
  }

  private void refuse(boolean wrong, String path, Field field, String expected, String remedy) {
    if (wrong) {
      throw new IllegalArgumentException("'" + field.name() + "' must be " + expected + ", and " + path
          + " is declared as '" + member + "'; " + remedy);
    }
  }
}
