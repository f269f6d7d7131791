package org.robotui.script.internal.action;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import org.robotui.api.script.ScriptLine;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;

/**
 * Writes data as scripts give them to {@code send}.
 *
 * @param robot whose frames are written without it
 */
record ValueLiteral(String robot) {
  private static final int LONGEST = 2000;

  /** The words; none for what a script cannot make, or what is too long to be read. */
  Optional<String> of(Record value) {
    try {
      return Optional.of(words(value)).filter(w -> w.length() <= LONGEST);
    } catch (ReflectiveOperationException | UnsupportedOperationException e) {
      return Optional.empty();
    }
  }

  private String words(Object value) throws ReflectiveOperationException {
    return switch (value) {
      case FrameId frame -> ScriptLine.literal(frame(frame));
      case Doubles numbers -> ScriptLine.literal(IntStream.range(0, numbers.size()).mapToObj(numbers::get).toList());
      case Enum<?> word -> ScriptLine.literal(word.name().toLowerCase(Locale.ROOT));
      case Record made -> fields(made);
      case Iterable<?> items -> list(items);
      case String text -> ScriptLine.literal(text);
      case Number number -> ScriptLine.literal(number);
      case Boolean flag -> flag.toString();
      default -> throw new UnsupportedOperationException(value.getClass().getName());
    };
  }

  private String frame(FrameId frame) {
    return frame.robot().equals(robot) && frame.name().indexOf(':') < 0 ? frame.name()
        : frame.robot() + ":" + frame.name();
  }

  private String list(Iterable<?> items) throws ReflectiveOperationException {
    List<String> all = new ArrayList<>();
    for (Object item : StreamSupport.stream(items.spliterator(), false).toList()) {
      all.add(words(item));
    }
    return all.stream().collect(Collectors.joining(", ", "[", "]"));
  }

  private String fields(Record made) throws ReflectiveOperationException {
    List<String> all = new ArrayList<>();
    for (RecordComponent field : made.getClass().getRecordComponents()) {
      Object value = field.getAccessor().invoke(made);
      Optional<?> given = value instanceof Optional<?> optional ? optional : Optional.of(value);
      if (given.isPresent()) {
        all.add(field.getName() + ": " + words(given.get()));
      }
    }
    return all.stream().collect(Collectors.joining(", ", "{", "}"));
  }
}
