package org.robotui.message;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;

/** Which Java types hold which fields. */
final class JavaForm {

  private JavaForm() {}

  /** Why a component cannot hold a field, empty if it can. */
  static Optional<String> misfit(RecordComponent component, Layout.Field field) {
    Class<?> type = component.getType();
    boolean fits = field.nested() == null ? type == primitive(field) : holdsMessages(component, field);
    boolean texts =
        type != List.class || field.nested() != null || element(component).equals(Optional.of(String.class));
    return fits && texts
        ? Optional.empty()
        : Optional.of("is " + component.getGenericType().getTypeName() + ", but field " + field.name() + " is "
            + field.type() + " and needs " + needed(field));
  }

  /** The class of the elements of a list. */
  static Optional<Class<?>> element(RecordComponent component) {
    if (component.getGenericType() instanceof ParameterizedType list) {
      Type element = list.getActualTypeArguments()[0];
      return element instanceof Class<?> known ? Optional.of(known) : Optional.empty();
    }
    return Optional.empty();
  }

  /** How many numbers of which type a message has that consists of nothing else, such as a point. */
  static Optional<Flat> flat(Layout message) {
    List<Layout.Field> fields = message.fields();
    boolean flat = !fields.isEmpty();
    for (Layout.Field each : fields) {
      flat &= each.primitive() == fields.getFirst().primitive()
          && each.nested() == null && each.type().arity() == FieldType.Arity.ONE && !each.primitive().isText();
    }
    return flat ? Optional.of(new Flat(fields.getFirst().primitive(), fields.size())) : Optional.empty();
  }

  /** Messages that consist of numbers of one type. */
  record Flat(Primitive type, int width) {}

  private static boolean holdsMessages(RecordComponent component, Layout.Field field) {
    if (!field.type().isArray()) {
      return component.getType().isRecord();
    }
    if (component.getType() == List.class) {
      Optional<Class<?>> element = element(component);
      return element.isPresent() && element.get().isRecord();
    }
    Optional<Flat> flat = flat(field.nested());
    return flat.isPresent() && component.getType() == array(flat.get().type());
  }

  private static Class<?> primitive(Layout.Field field) {
    return field.type().isArray() ? array(field.primitive()) : single(field.primitive());
  }

  private static Class<?> single(Primitive type) {
    return switch (type) {
      case BOOL -> boolean.class;
      case INT8, UINT8, BYTE, CHAR, INT16, UINT16, INT32 -> int.class;
      case UINT32, INT64, UINT64, TIME, DURATION -> long.class;
      case FLOAT32 -> float.class;
      case FLOAT64 -> double.class;
      case STRING, WSTRING -> String.class;
    };
  }

  /** Null for arrays of times, which no Java type holds. */
  private static Class<?> array(Primitive type) {
    return switch (type) {
      case BOOL, INT8, UINT8, BYTE, CHAR -> ByteBuffer.class;
      case INT16, UINT16 -> short[].class;
      case INT32, UINT32 -> int[].class;
      case INT64, UINT64 -> long[].class;
      case FLOAT32 -> float[].class;
      case FLOAT64 -> double[].class;
      case STRING, WSTRING -> List.class;
      case TIME, DURATION -> null;
    };
  }

  private static String needed(Layout.Field field) {
    if (field.nested() != null) {
      return field.type().isArray() ? "a list of records" : "a record";
    }
    Class<?> type = primitive(field);
    return type == null ? "to be left out" : type == List.class ? "a list of strings" : type.getSimpleName();
  }
}
