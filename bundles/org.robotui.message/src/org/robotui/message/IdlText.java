package org.robotui.message;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Reads the part of IDL that packages of ROS 2 define their types with, and writes it as the definitions that all of
 * this library is made for: structures, constants, names for types, enumerations, sequences, arrays, bounds and
 * defaults.
 */
final class IdlText {

  private static final Map<String, List<String>> PARTS = Map.of("msg", List.of(""), "srv",
      List.of("_Request", "_Response"), "action", List.of("_Goal", "_Result", "_Feedback"));
  private static final String CONSTANTS = "_Constants";
  /** What generators put where a structure would be empty; definitions say nothing instead. */
  private static final String ONLY_MEMBER = "structure_needs_at_least_one_member";

  private final IdlTokens in;
  private final IdlTypes types;
  private final Map<String, List<String>> structs = new LinkedHashMap<>();
  private final Map<String, List<String>> constants = new HashMap<>();

  private IdlText(String type, String text) throws DefinitionException {
    this.in = new IdlTokens(type, text);
    this.types = new IdlTypes(in);
  }

  /**
   * The definition of a type.
   *
   * @param type the full name of two parts
   * @param kind {@code msg}, {@code srv} or {@code action}
   * @param text the file
   */
  static String definition(String type, String kind, String text) throws DefinitionException {
    IdlText idl = new IdlText(type, text);
    idl.module("");
    String name = type.substring(type.indexOf('/') + 1);
    List<String> parts = new ArrayList<>();
    for (String part : PARTS.get(kind)) {
      List<String> fields = idl.structs.get(name + part);
      if (fields == null) {
        throw new DefinitionException(type, "the file in IDL has no structure " + name + part);
      }
      List<String> lines = new ArrayList<>(idl.constants.getOrDefault(name + part + CONSTANTS, List.of()));
      lines.addAll(fields);
      parts.add(lines.stream().map(line -> line + "\n").collect(Collectors.joining()));
    }
    return String.join("---\n", parts);
  }

  private void module(String name) throws DefinitionException {
    while (in.more() && !in.peek().equals("}")) {
      annotations();
      switch (in.take()) {
        case "module" -> {
          String inner = in.take();
          in.expect("{");
          module(inner);
          in.expect("}");
          in.expect(";");
        }
        case "struct" -> struct();
        case "const" -> constant(name);
        case "typedef" -> typedef();
        case "enum" -> enumeration();
        case String other -> throw in.unsupported("'" + other + "'");
      }
    }
  }

  private void struct() throws DefinitionException {
    String name = in.take();
    List<String> fields = new ArrayList<>();
    in.expect("{");
    while (!in.takeIf("}")) {
      Optional<String> initial = annotations();
      String type = types.read();
      do {
        String field = in.take();
        String whole = types.dimensions(type);
        boolean array = whole.endsWith("]");
        if (!field.equals(ONLY_MEMBER)) {
          fields.add(whole + " " + field + initial.filter(value -> !array).map(value -> " " + value).orElse(""));
        }
      } while (in.takeIf(","));
      in.expect(";");
    }
    in.expect(";");
    structs.put(name, fields);
  }

  private void constant(String module) throws DefinitionException {
    String type = types.read();
    String name = in.take();
    in.expect("=");
    constants.computeIfAbsent(module, key -> new ArrayList<>()).add(type + " " + name + "=" + value());
    in.expect(";");
  }

  private void typedef() throws DefinitionException {
    String type = types.read();
    String name = in.take();
    types.define(name, types.dimensions(type));
    in.expect(";");
  }

  /** A number is sent for the word; which word it stands for is lost in a definition. */
  private void enumeration() throws DefinitionException {
    types.define(in.take(), "int32");
    in.expect("{");
    do {
      in.take();
    } while (in.takeIf(","));
    in.expect("}");
    in.expect(";");
  }

  /** Texts may be written in pieces. */
  private String value() throws DefinitionException {
    String first = in.take();
    if (!first.startsWith("\"")) {
      return first.equals("-") || first.equals("+") ? first + in.take() : IdlTypes.literal(first);
    }
    StringBuilder text = new StringBuilder(first.substring(0, first.length() - 1));
    while (in.peek().startsWith("\"")) {
      String more = in.take();
      text.append(more, 1, more.length() - 1);
    }
    return text.append('"').toString();
  }

  /** Passes over annotations; answers the default that one of them gives. */
  private Optional<String> annotations() throws DefinitionException {
    Optional<String> initial = Optional.empty();
    while (in.takeIf("@")) {
      boolean isDefault = in.take().equals("default");
      if (in.takeIf("(")) {
        if (isDefault && in.takeIf("value")) {
          in.expect("=");
          initial = Optional.of(value());
        }
        close();
      }
    }
    return initial;
  }

  private void close() throws DefinitionException {
    for (int open = 1; open > 0;) {
      String word = in.take();
      open += word.equals("(") ? 1 : word.equals(")") ? -1 : 0;
    }
  }
}
