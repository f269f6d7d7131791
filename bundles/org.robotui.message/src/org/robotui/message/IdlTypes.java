package org.robotui.message;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/** The types of fields in IDL, as definitions of messages write them. */
final class IdlTypes {

  private static final Map<String, String> BUILT_IN = Map.ofEntries(Map.entry("boolean", "bool"),
      Map.entry("octet", "byte"), Map.entry("char", "uint8"), Map.entry("float", "float32"),
      Map.entry("double", "float64"), Map.entry("short", "int16"), Map.entry("long", "int32"),
      Map.entry("long long", "int64"), Map.entry("unsigned short", "uint16"), Map.entry("unsigned long", "uint32"),
      Map.entry("unsigned long long", "uint64"));
  private static final Set<String> SAME =
      Set.of("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64");

  private final IdlTokens in;
  private final Map<String, String> defined = new HashMap<>();

  IdlTypes(IdlTokens in) {
    this.in = in;
  }

  void define(String name, String type) {
    defined.put(name, type);
  }

  /** Reads a type. */
  String read() throws DefinitionException {
    String word = in.take();
    return switch (word) {
      case "sequence" -> sequence();
      case "string", "wstring" -> in.takeIf("<") ? word + "<=" + bound() : word;
      case "unsigned", "long" -> number(word);
      default -> named(word.startsWith("::") ? word.substring(2) : word);
    };
  }

  private String sequence() throws DefinitionException {
    in.expect("<");
    String element = read();
    if (element.endsWith("]")) {
      throw in.unsupported("a sequence of sequences or arrays");
    }
    if (in.takeIf(",")) {
      return element + "[<=" + bound() + "]";
    }
    in.expect(">");
    return element + "[]";
  }

  private String bound() throws DefinitionException {
    String digits = in.take();
    in.expect(">");
    return digits;
  }

  private String number(String first) throws DefinitionException {
    StringBuilder words = new StringBuilder(first);
    if (first.equals("unsigned")) {
      words.append(' ').append(in.take());
    }
    if (words.toString().endsWith("long") && in.takeIf("long")) {
      words.append(" long");
    }
    String known = BUILT_IN.get(words.toString());
    if (known == null || in.peek().equals("double")) {
      throw in.unsupported("the type '" + words + "'");
    }
    return known;
  }

  private String named(String word) throws DefinitionException {
    if (SAME.contains(word)) {
      return word;
    }
    if (BUILT_IN.containsKey(word)) {
      return BUILT_IN.get(word);
    }
    String last = word.substring(word.lastIndexOf(':') + 1);
    if (defined.containsKey(last)) {
      return defined.get(last);
    }
    int packageEnd = word.indexOf("::");
    if (word.equals("wchar")) {
      throw in.unsupported("the type 'wchar'");
    }
    return packageEnd < 0 ? word : word.substring(0, packageEnd) + "/" + last;
  }

  /** Reads the dimensions behind a name, if there are any. */
  String dimensions(String type) throws DefinitionException {
    if (!in.takeIf("[")) {
      return type;
    }
    String length = in.take();
    in.expect("]");
    if (type.endsWith("]") || in.peek().equals("[")) {
      throw in.unsupported("an array of arrays or sequences");
    }
    return type + "[" + length + "]";
  }

  static String literal(String word) {
    return word.equals("TRUE") || word.equals("FALSE") ? word.toLowerCase(Locale.ROOT) : word;
  }
}
