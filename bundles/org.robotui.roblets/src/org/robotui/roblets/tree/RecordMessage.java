package org.robotui.roblets.tree;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Messages of a record: each component that is a number, a flag, a text or an enumeration is an attribute, each that is
 * a record is an element. Records and their components need no more than that; {@link BodyMessage} and {@link BodyUnit}
 * say what names do not.
 *
 * @param <T> the record
 */
public final class RecordMessage<T extends Record> {
  private static final Map<Class<?>, String> KINDS = Map.of(double.class, "number", float.class, "number", int.class,
      "whole", long.class, "whole", boolean.class, "flag", String.class, "text");

  private final Class<T> type;
  private final String name;

  private RecordMessage(Class<T> type, String name) {
    this.type = type;
    this.name = BodyElement.checked(name);
    for (RecordComponent component : type.getRecordComponents()) {
      Class<?> of = component.getType();
      if (!KINDS.containsKey(of) && !of.isEnum() && !of.isRecord()) {
        throw new IllegalArgumentException(type.getName() + "." + component.getName() + " is a " + of.getSimpleName()
            + "; components of messages are numbers, flags, texts, enumerations and records");
      }
    }
  }

  /**
   * Messages of a record.
   *
   * @param type the record
   * @param <T> the record
   * @return reads and writes them
   * @throws IllegalArgumentException where a component can be no part of a message; names it
   */
  public static <T extends Record> RecordMessage<T> of(Class<T> type) {
    return new RecordMessage<>(type, name(type));
  }

  private static String name(Class<?> type) {
    String said = Optional.ofNullable(type.getAnnotation(BodyMessage.class)).map(BodyMessage::value).orElse("");
    String simple = type.getSimpleName();
    return said.isEmpty() ? simple.substring(0, 1).toLowerCase(Locale.ROOT) + simple.substring(1) : said;
  }

  /**
   * How it is described to who does not know the record.
   *
   * @return its name, what it is, and its fields; those of records in it are called after both, with {@code /} between
   */
  public BodyForm form() {
    List<BodyForm.Field> fields = new ArrayList<>();
    describe(type, "", fields);
    return new BodyForm(name,
        Optional.ofNullable(type.getAnnotation(BodyMessage.class)).map(BodyMessage::as).orElse(""), fields);
  }

  private static void describe(Class<?> record, String before, List<BodyForm.Field> fields) {
    for (RecordComponent component : record.getRecordComponents()) {
      if (component.getType().isRecord()) {
        describe(component.getType(), before + component.getName() + "/", fields);
      } else {
        fields.add(new BodyForm.Field(before + component.getName(), KINDS.getOrDefault(component.getType(), "text"),
            Optional.ofNullable(component.getAnnotation(BodyUnit.class)).map(BodyUnit::value).orElse("")));
      }
    }
  }

  /**
   * A record as a message.
   *
   * @param record what to say
   * @return the message
   */
  public BodyElement element(T record) {
    return element(name, record);
  }

  /**
   * A record of any type as a message.
   *
   * @param record what to say
   * @return the message
   */
  public static BodyElement ofRecord(Record record) {
    return element(name(record.getClass()), record);
  }

  private static BodyElement element(String name, Record record) {
    Map<String, String> attributes = new LinkedHashMap<>();
    List<BodyElement> children = new ArrayList<>();
    for (RecordComponent component : record.getClass().getRecordComponents()) {
      Object value = value(component, record);
      if (value instanceof Record inner) {
        children.add(element(component.getName(), inner));
      } else {
        attributes.put(component.getName(), value instanceof Enum<?> word ? word.name() : String.valueOf(value));
      }
    }
    return new BodyElement(name, attributes, "", children);
  }

  private static Object value(RecordComponent component, Record record) {
    try {
      component.getAccessor().setAccessible(true); // records may be private to those who use them
      return component.getAccessor().invoke(record);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(record.getClass().getName() + "." + component.getName() + " cannot be read", e);
    }
  }

  /**
   * A message as a record. What the record does not have is left out; texts that are not there are empty, flags are
   * false, numbers have to be there.
   *
   * @param element the message
   * @return the record
   * @throws IllegalArgumentException where something is missing or wrong; names it
   */
  public T record(BodyElement element) {
    return type.cast(record(type, element));
  }

  private static Object record(Class<?> type, BodyElement element) {
    RecordComponent[] components = type.getRecordComponents();
    Object[] values = new Object[components.length];
    for (int i = 0; i < values.length; i++) {
      Class<?> of = components[i].getType();
      String part = components[i].getName();
      values[i] = of.isRecord()
          ? record(of, element.child(part).orElseThrow(
              () -> new IllegalArgumentException(element.name() + " has no element '" + part + "'")))
          : plain(of, part, element);
    }
    try {
      Constructor<?> constructor = type.getDeclaredConstructor(
          Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
      constructor.setAccessible(true);
      return constructor.newInstance(values);
    } catch (InvocationTargetException e) {
      throw new IllegalArgumentException(element.name() + ": " + e.getCause().getMessage(), e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(type.getName() + " cannot be made", e);
    }
  }

  private static Object plain(Class<?> of, String part, BodyElement element) {
    String text = element.attribute(part).orElse("");
    if (of == String.class) {
      return text;
    } else if (of == boolean.class) {
      return Boolean.parseBoolean(text);
    } else if (of.isEnum()) {
      return Arrays.stream(of.getEnumConstants()).filter(c -> ((Enum<?>) c).name().equals(text)).findFirst()
          .orElseThrow(() -> new IllegalArgumentException(
              element.name() + " has no '" + part + "' of " + Arrays.toString(of.getEnumConstants())));
    }
    return number(of, part, text, element);
  }

  private static Object number(Class<?> of, String part, String text, BodyElement element) {
    try {
      if (of == long.class) {
        return Long.parseLong(text);
      }
      if (of == int.class) {
        return Integer.parseInt(text);
      }
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(element.name() + " has no whole number '" + part + "'", e);
    }
    double value = element.number(part)
        .orElseThrow(() -> new IllegalArgumentException(element.name() + " has no number '" + part + "'"));
    return of == float.class ? (Object) (float) value : (Object) value;
  }
}
