package org.robotui.player.layout;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robotui.player.wire.MessageType;

/**
 * Reads the description of one interface. Lines of a file:
 *
 * <pre> interface 62 ranger data 1 ranges ranges what it carries is the structure 'ranges' request 5 get_config - ->
 * config nothing asked, a structure answered struct ranges # a comment f64[] ranges [m] # type, name, unit, comment
 * </pre>
 *
 * Types: u8 i8 u16 i16 u32 i32 i64 f32 f64 bool, string, label (a string that is left out when empty), a structure of
 * this file or of the common ones; {@code T[]} for a length in the message, {@code T[6]} for a fixed one.
 * {@code count name} is where Player puts the length of a later array.
 */
final class LayoutParser {

  private static final Pattern INTERFACE = Pattern.compile("interface\\s+(\\d{1,5})\\s+(\\w+)");
  private static final Pattern MESSAGE =
      Pattern.compile("(data|command|request|sync)\\s+(\\d{1,3})\\s+(\\w+)(?:\\s+(\\w+|-))?(?:\\s+->\\s+(\\w+))?");
  private static final Pattern STRUCT = Pattern.compile("struct\\s+(\\w+)");
  private static final Pattern FIELD = Pattern.compile("(\\w+)(\\[(\\d{0,5})])?\\s+(\\w+)(?:\\s+\\[(.+)])?");
  private static final Pattern COUNT = Pattern.compile("count\\s+(\\w+)");

  private record Line(int number, String text, String comment) {}

  private record Header(Line line, MessageType type, int subtype, String name, String ask, String answer) {}

  private final String file;
  private final Map<String, StructLayout> common;
  private final Map<String, Line> titles = new LinkedHashMap<>();
  private final Map<String, List<Line>> bodies = new LinkedHashMap<>();
  private final List<Header> headers = new ArrayList<>();
  private final Map<String, StructLayout> done = new LinkedHashMap<>();
  private List<Line> body = new ArrayList<>();
  private int code = -1;
  private String name = "";

  private LayoutParser(String file, Map<String, StructLayout> common) {
    this.file = file;
    this.common = common;
  }

  static InterfaceLayout parse(String file, String text, Map<String, StructLayout> common) {
    return new LayoutParser(file, common).read(text);
  }

  private InterfaceLayout read(String text) {
    String[] lines = text.split("\n", -1);
    for (int i = 0; i < lines.length; i++) {
      int hash = lines[i].indexOf('#');
      String comment = hash < 0 ? "" : lines[i].substring(hash + 1).strip();
      line(new Line(i + 1, (hash < 0 ? lines[i] : lines[i].substring(0, hash)).stripTrailing(), comment));
    }
    if (code < 0) {
      throw new LayoutException(file, 1, "no line 'interface CODE NAME'");
    }
    bodies.keySet().forEach(each -> struct(each, titles.get(each), 0));
    Map<String, StructLayout> all = new LinkedHashMap<>(common);
    all.putAll(done);
    return new InterfaceLayout(code, name, headers.stream().map(this::message).toList(), all);
  }

  private void line(Line line) {
    if (line.text.isBlank()) {
      return;
    }
    if (Character.isWhitespace(line.text.charAt(0))) {
      body.add(line);
      return;
    }
    body = new ArrayList<>();
    Matcher kind = INTERFACE.matcher(line.text);
    Matcher struct = STRUCT.matcher(line.text);
    if (kind.matches()) {
      code = Integer.parseInt(kind.group(1));
      name = kind.group(2);
    } else if (struct.matches()) {
      require(bodies.put(struct.group(1), body) == null, line,
          "the structure '" + struct.group(1) + "' is described twice");
      titles.put(struct.group(1), line);
    } else {
      headers.add(header(line));
    }
  }

  private Header header(Line line) {
    Matcher message = MESSAGE.matcher(line.text);
    if (!message.matches()) {
      throw new LayoutException(file, line.number,
          "'" + line.text + "' is neither an interface, a message nor a structure");
    }
    MessageType type = switch (message.group(1)) {
      case "data" -> MessageType.DATA;
      case "command" -> MessageType.COMMAND;
      case "sync" -> MessageType.SYNC;
      default -> MessageType.REQUEST;
    };
    return new Header(line, type, Integer.parseInt(message.group(2)), message.group(3),
        Optional.ofNullable(message.group(4)).orElse("-"), Optional.ofNullable(message.group(5)).orElse("-"));
  }

  private MessageLayout message(Header header) {
    return new MessageLayout(header.type, header.subtype, header.name, payload(header.ask, header.line),
        payload(header.answer, header.line), header.line.comment);
  }

  private Optional<StructLayout> payload(String type, Line line) {
    return type.equals("-") ? Optional.empty() : Optional.of(struct(type, line, 0));
  }

  private StructLayout struct(String type, Line user, int depth) {
    if (done.containsKey(type)) {
      return done.get(type);
    }
    if (!bodies.containsKey(type)) {
      return Optional.ofNullable(common.get(type))
          .orElseThrow(() -> new LayoutException(file, user.number, "there is no type '" + type + "'"));
    }
    require(depth <= bodies.size(), user, "the structure '" + type + "' contains itself");
    Set<String> counted =
        bodies.get(type).stream().map(line -> COUNT.matcher(line.text.strip())).filter(Matcher::matches)
            .map(count -> count.group(1)).collect(Collectors.toSet());
    List<FieldLayout> fields = bodies.get(type).stream().map(line -> field(line, counted, depth)).toList();
    checkNames(fields, bodies.get(type));
    require(!fields.isEmpty(), user, "the structure '" + type + "' has no field");
    StructLayout struct = new StructLayout(type, titles.get(type).comment, fields);
    done.put(type, struct);
    return struct;
  }

  private void checkNames(List<FieldLayout> fields, List<Line> lines) {
    Set<String> names = new HashSet<>();
    for (int i = 0; i < fields.size(); i++) {
      FieldLayout field = fields.get(i);
      if (field.arity() == FieldLayout.Arity.COUNT) {
        boolean array = fields.subList(i, fields.size()).stream().anyMatch(each -> each.name().equals(field.name())
            && each.arity() == FieldLayout.Arity.COUNTED_EARLIER);
        require(array, lines.get(i), "there is no array '" + field.name() + "' to count");
      } else {
        require(names.add(field.name()), lines.get(i), "the field '" + field.name() + "' is described twice");
      }
    }
  }

  private void require(boolean right, Line line, String otherwise) {
    if (!right) {
      throw new LayoutException(file, line.number, otherwise);
    }
  }

  private FieldLayout field(Line line, Set<String> counted, int depth) {
    String text = line.text.strip();
    Matcher count = COUNT.matcher(text);
    if (count.matches()) {
      return new FieldLayout(count.group(1), Primitive.U32, FieldLayout.Arity.COUNT, 0, "", line.comment);
    }
    Matcher field = FIELD.matcher(text);
    if (!field.matches()) {
      throw new LayoutException(file, line.number, "'" + text + "' is no field: expected TYPE NAME [UNIT]");
    }
    String unit = Optional.ofNullable(field.group(5)).orElse("");
    FieldLayout.Arity arity = arity(field, counted);
    int length = arity == FieldLayout.Arity.FIXED ? Integer.parseInt(field.group(3)) : 0;
    return Primitive.of(field.group(1))
        .map(primitive -> new FieldLayout(field.group(4), primitive, arity, length, unit, line.comment))
        .orElseGet(() -> new FieldLayout(field.group(4), struct(field.group(1), line, depth + 1), arity, length, unit,
            line.comment));
  }

  private static FieldLayout.Arity arity(Matcher field, Set<String> counted) {
    if (field.group(2) == null) {
      return FieldLayout.Arity.ONE;
    }
    if (!field.group(3).isEmpty()) {
      return FieldLayout.Arity.FIXED;
    }
    return counted.contains(field.group(4)) ? FieldLayout.Arity.COUNTED_EARLIER : FieldLayout.Arity.COUNTED;
  }
}
