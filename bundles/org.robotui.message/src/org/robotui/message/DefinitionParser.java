package org.robotui.message;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the text of one message type by the rules of ROS's own generator. */
final class DefinitionParser {

  static final int MAX_TEXT = 1 << 20;

  private static final String HEADER = "std_msgs/Header";
  private static final Pattern TYPE =
      Pattern.compile("([A-Za-z]\\w*(?:/[A-Za-z]\\w*)?)(\\[(\\d{0,9})\\])?");
  private static final Pattern NAME = Pattern.compile("[A-Za-z]\\w*");

  private final String type;
  private final List<ConstantDefinition> constants = new ArrayList<>();
  private final List<FieldDefinition> fields = new ArrayList<>();
  private final Set<String> names = new HashSet<>();

  private DefinitionParser(String type) {
    this.type = type;
  }

  static MessageDefinition parse(String type, String text) throws DefinitionException {
    if (text.length() > MAX_TEXT) {
      throw new DefinitionException(type, "the text of " + text.length() + " characters is too long");
    }
    DefinitionParser parser = new DefinitionParser(type);
    String[] lines = text.split("\n", -1);
    for (int i = 0; i < lines.length; i++) {
      parser.line(lines[i], i + 1);
    }
    return new MessageDefinition(type, text, parser.constants, parser.fields);
  }

  private void line(String line, int number) throws DefinitionException {
    String clean = withoutComment(line);
    if (clean.isEmpty()) {
      return;
    }
    String name = clean.indexOf('=') >= 0 ? constant(line, clean, number) : field(clean, number);
    if (!NAME.matcher(name).matches()) {
      throw new DefinitionException(type, number, "'" + name + "' is no valid name");
    }
    if (!names.add(name)) {
      throw new DefinitionException(type, number, "the name '" + name + "' is used twice");
    }
  }

  private String constant(String line, String clean, int number) throws DefinitionException {
    String[] typed = clean.split("\\s+", 2);
    Optional<Primitive> primitive = Primitive.of(typed[0]);
    if (typed.length < 2 || primitive.isEmpty() || primitive.get().isTemporal()) {
      throw new DefinitionException(type, number, "'" + clean + "' is no constant: expected TYPE NAME=VALUE");
    }
    // in a text '#' is no comment: all that is right of the equals sign counts
    String source = primitive.get() == Primitive.STRING ? line.strip().split("\\s+", 2)[1] : typed[1];
    int equals = source.indexOf('=');
    String name = source.substring(0, equals).strip();
    constants.add(new ConstantDefinition(primitive.get(), name, source.substring(equals + 1).strip()));
    return name;
  }

  private String field(String clean, int number) throws DefinitionException {
    String[] words = clean.split("\\s+");
    Matcher typed = TYPE.matcher(words[0]);
    if (words.length != 2 || !typed.matches()) {
      throw new DefinitionException(type, number, "'" + clean + "' is no field: expected TYPE NAME");
    }
    fields.add(new FieldDefinition(fieldType(typed), words[1]));
    return words[1];
  }

  private FieldType fieldType(Matcher typed) {
    String base = fullName(typed.group(1));
    if (typed.group(2) == null) {
      return new FieldType(base, FieldType.Arity.ONE, 0);
    }
    String length = typed.group(3);
    return length.isEmpty()
        ? new FieldType(base, FieldType.Arity.VARIABLE, 0)
        : new FieldType(base, FieldType.Arity.FIXED, Integer.parseInt(length));
  }

  private String fullName(String base) {
    if (base.equals("Header") || base.equals("roslib/Header")) {
      return HEADER;
    }
    boolean complete = base.indexOf('/') >= 0 || Primitive.of(base).isPresent() || type.indexOf('/') < 0;
    return complete ? base : type.substring(0, type.indexOf('/') + 1) + base;
  }

  private static String withoutComment(String line) {
    int hash = line.indexOf('#');
    return (hash < 0 ? line : line.substring(0, hash)).strip();
  }
}
