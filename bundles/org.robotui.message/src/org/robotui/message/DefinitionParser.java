package org.robotui.message;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the text of one message type by the rules of the generators of ROS 1 and ROS 2. */
final class DefinitionParser {

  static final int MAX_TEXT = 1 << 20;

  /** What the generator of ROS 2 gives a message without fields, as a structure in C has one. */
  private static final FieldDefinition ONLY_MEMBER =
      new FieldDefinition(new FieldType("uint8", FieldType.Arity.ONE, 0), "structure_needs_at_least_one_member");

  /** A pattern is made when the first constant is met. */
  private static final class Constants {
    static final Pattern ROS2 = Pattern.compile("\\S+\\s+[A-Za-z]\\w*\\s*=.*");
  }

  private final String type;
  private final TypeNames types;
  private final List<ConstantDefinition> constants = new ArrayList<>();
  private final List<FieldDefinition> fields = new ArrayList<>();
  private final Set<String> names = new HashSet<>();

  private DefinitionParser(String type, Generation generation) {
    this.type = type;
    this.types = new TypeNames(type, generation);
  }

  static MessageDefinition parse(String type, String text, Generation generation) throws DefinitionException {
    if (text.length() > MAX_TEXT) {
      throw new DefinitionException(type, "the text of " + text.length() + " characters is too long");
    }
    DefinitionParser parser = new DefinitionParser(Generation.plainName(type), generation);
    String[] lines = text.split("\n", -1);
    for (int i = 0; i < lines.length; i++) {
      parser.line(lines[i], i + 1, generation);
    }
    if (parser.fields.isEmpty() && generation == Generation.ROS2) {
      parser.fields.add(ONLY_MEMBER);
    }
    return new MessageDefinition(parser.type, text, parser.constants, parser.fields);
  }

  private void line(String line, int number, Generation generation) throws DefinitionException {
    String clean = withoutComment(line);
    if (clean.isEmpty()) {
      return;
    }
    boolean constant =
        clean.indexOf('=') >= 0 && (generation == Generation.ROS1 || Constants.ROS2.matcher(clean).matches());
    String name = constant ? constant(line, clean, number, generation) : field(line, clean, number, generation);
    if (!Names.isName(name)) {
      throw new DefinitionException(type, number, "'" + name + "' is no valid name");
    }
    if (!names.add(name)) {
      throw new DefinitionException(type, number, "the name '" + name + "' is used twice");
    }
  }

  private String constant(String line, String clean, int number, Generation generation) throws DefinitionException {
    List<String> typed = Names.words(clean, 2);
    Optional<Primitive> primitive = types.primitive(typed.getFirst());
    if (typed.size() < 2 || primitive.isEmpty() || primitive.get().isTemporal()) {
      throw new DefinitionException(type, number, "'" + clean + "' is no constant: expected TYPE NAME=VALUE");
    }
    // in a text '#' is no comment: all that is right of the equals sign counts
    String source = primitive.get().isText() ? Names.words(line.strip(), 2).get(1) : typed.get(1);
    int equals = source.indexOf('=');
    String name = source.substring(0, equals).strip();
    String value = source.substring(equals + 1).strip();
    boolean quoted = generation == Generation.ROS2 && primitive.get().isText();
    constants.add(new ConstantDefinition(primitive.get(), name, quoted ? Literals.text(value) : value));
    return name;
  }

  private String field(String line, String clean, int number, Generation generation) throws DefinitionException {
    List<String> words = Names.words(clean, 3);
    Optional<FieldType> known = types.field(words.getFirst());
    if (words.size() < 2 || words.size() > 2 && generation == Generation.ROS1 || known.isEmpty()) {
      throw new DefinitionException(type, number, "'" + clean + "' is no field: expected TYPE NAME");
    }
    Optional<String> initial = words.size() < 3 ? Optional.empty()
        : Optional.of(isText(known.get().base()) ? Names.words(line.strip(), 3).get(2) : words.get(2));
    fields.add(new FieldDefinition(known.get(), words.get(1), initial));
    return words.get(1);
  }

  private static boolean isText(String base) {
    Optional<Primitive> primitive = Primitive.of(base);
    return primitive.isPresent() && primitive.get().isText();
  }

  private static String withoutComment(String line) {
    int hash = line.indexOf('#');
    return (hash < 0 ? line : line.substring(0, hash)).strip();
  }

  /** The types of fields as one definition writes them. */
  private record TypeNames(String within, Generation generation) {

    private static final String HEADER = "std_msgs/Header";
    /** Of what is no name alone, nor an array of a fixed length or of any. */
    private static final class Forms {
      static final Pattern ROS1 = Pattern.compile("([A-Za-z]\\w*(?:/[A-Za-z]\\w*)?)()(\\[()(\\d{0,9})\\])?");
      static final Pattern ROS2 = Pattern.compile(
          "([A-Za-z]\\w*(?:/(?:msg/)?[A-Za-z]\\w*)?)(?:<=(\\d{1,9}))?(\\[(<=)?(\\d{0,9})\\])?");
    }

    Optional<FieldType> field(String word) {
      int bracket = word.indexOf('[');
      String base = bracket < 0 ? word : word.substring(0, bracket);
      int last = word.length() - 1;
      boolean plain = bracket < 0 || word.charAt(last) == ']'
          && (bracket + 1 == last || Names.isCount(word, bracket + 1, last));
      if (!plain || !Names.isName(base) && !Names.isFullName(base)) {
        return rare(word);
      }
      String digits = bracket < 0 ? "" : word.substring(bracket + 1, last);
      return Optional.of(type(fullName(base), bracket < 0 ? null : word, digits, number(digits), false, 0));
    }

    private Optional<FieldType> rare(String word) {
      Matcher typed = (generation == Generation.ROS1 ? Forms.ROS1 : Forms.ROS2).matcher(word);
      if (!typed.matches()) {
        return Optional.empty();
      }
      String base = fullName(typed.group(1));
      int textBound = number(typed.group(2));
      int length = number(typed.group(5));
      boolean bounded = "<=".equals(typed.group(4));
      boolean senseless = bounded && length == 0
          || typed.group(2) != null && !typed.group(2).isEmpty()
              && (textBound == 0 || !isText(base));
      return senseless ? Optional.empty()
          : Optional.of(type(base, typed.group(3), typed.group(5), length, bounded, textBound));
    }

    private static FieldType type(String base, String brackets, String digits, int length, boolean bounded,
        int textBound) {
      if (brackets == null) {
        return new FieldType(base, FieldType.Arity.ONE, 0, 0, textBound);
      }
      return digits.isEmpty() || bounded
          ? new FieldType(base, FieldType.Arity.VARIABLE, 0, length, textBound)
          : new FieldType(base, FieldType.Arity.FIXED, length, 0, textBound);
    }

    private static int number(String digits) {
      return digits == null || digits.isEmpty() ? 0 : Integer.parseInt(digits);
    }

    /** The built-in type of a constant, whose bound does not matter. */
    Optional<Primitive> primitive(String word) {
      int bound = word.indexOf("<=");
      String name = bound < 0 || generation == Generation.ROS1 ? word : word.substring(0, bound);
      return builtIn(name) ? Primitive.of(name) : Optional.empty();
    }

    private boolean builtIn(String name) {
      Optional<Primitive> known = Primitive.of(name);
      return known.isPresent() && (known.get() != Primitive.WSTRING || generation == Generation.ROS2);
    }

    private String fullName(String written) {
      String base = Generation.plainName(written);
      if (base.equals("Header") || base.equals("roslib/Header")) {
        return HEADER;
      }
      if (generation == Generation.ROS2 && base.startsWith("builtin_interfaces/")) {
        return builtInTime(base);
      }
      boolean complete = base.indexOf('/') >= 0 || builtIn(base) || within.indexOf('/') < 0;
      return complete ? base : within.substring(0, within.indexOf('/') + 1) + base;
    }

    private static String builtInTime(String base) {
      return switch (base) {
        case "builtin_interfaces/Time" -> Primitive.TIME.rosName();
        case "builtin_interfaces/Duration" -> Primitive.DURATION.rosName();
        default -> base;
      };
    }
  }
}
