package org.robotui.lcm.type;

import java.util.LinkedHashSet;
import java.util.SequencedSet;
import java.util.stream.Collectors;

/** Declarations as text, which {@link TypeParser} reads again. */
public final class TypeText {
  private TypeText() {}

  /**
   * A type and those that it holds, as a {@code .lcm} file would declare them.
   *
   * @param type the type
   * @param types all types
   * @return the text
   */
  public static String of(LcmType type, TypeLibrary types) {
    SequencedSet<String> names = new LinkedHashSet<>();
    collect(type.name(), types, names);
    return names.stream().flatMap(name -> types.type(name).stream()).map(t -> struct(t.definition()))
        .collect(Collectors.joining("\n"));
  }

  private static void collect(String name, TypeLibrary types, SequencedSet<String> names) {
    types.type(name).filter(t -> names.add(name))
        .ifPresent(t -> t.definition().members().forEach(m -> collect(m.type(), types, names)));
  }

  private static String struct(TypeDefinition.Struct struct) {
    String constants = struct.constants().stream()
        .map(c -> "  const " + c.type().lcmName() + " " + c.name() + " = " + c.text() + ";\n")
        .collect(Collectors.joining());
    String members = struct.members().stream().map(MemberDefinition::toString).map(m -> "  " + m + ";\n")
        .collect(Collectors.joining());
    return "struct " + struct.name() + " {\n" + constants + members + "}\n";
  }
}
