package org.robotui.script.internal.function;

import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.script.ScriptFailure;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.geometry.Quaternion;

/**
 * Makes records of plain values, by their components, so that a script can give any command and ask anything. What is
 * absent is nothing: zero, empty, or what the type has as its constant {@code ZERO} or {@code IDENTITY}.
 *
 * @param robot to whom frames belong that name no robot
 */
record RecordMaker(String robot) {
  private static final Set<String> ANGLES = Set.of("roll", "pitch", "yaw");

  /** A record of a type, of the fields by name. */
  Record make(Class<?> type, Map<String, Object> fields) throws ScriptFailure {
    return record(type, fields, type.getSimpleName());
  }

  private Record record(Class<?> type, Map<?, ?> fields, String path) throws ScriptFailure {
    if (!type.isRecord()) {
      throw new ScriptFailure(path + ": scripts cannot make a " + type.getSimpleName());
    }
    RecordComponent[] components = type.getRecordComponents();
    refuseUnknown(components, fields, path);
    Object[] values = new Object[components.length];
    Class<?>[] types = new Class<?>[components.length];
    for (int i = 0; i < values.length; i++) {
      String name = components[i].getName();
      types[i] = components[i].getType();
      values[i] = value(components[i].getGenericType(), fields.get(name), path + "." + name);
    }
    try {
      return (Record) type.getConstructor(types).newInstance(values);
    } catch (InvocationTargetException e) {
      throw new ScriptFailure(path + ": " + e.getCause().getMessage());
    } catch (ReflectiveOperationException e) {
      throw new ScriptFailure(path + ": a " + type.getSimpleName() + " cannot be made: " + e.getMessage());
    }
  }

  private static void refuseUnknown(RecordComponent[] components, Map<?, ?> fields, String path)
      throws ScriptFailure {
    List<String> known = Stream.of(components).map(RecordComponent::getName).toList();
    Optional<?> unknown = fields.keySet().stream().filter(name -> !known.contains(name)).findFirst();
    if (unknown.isPresent()) {
      throw new ScriptFailure(
          path + " has no field '" + unknown.get() + "'; it has " + String.join(", ", known));
    }
  }

  private Object value(Type type, Object given, String path) throws ScriptFailure {
    Class<?> raw = raw(type);
    if (raw == Optional.class) {
      return given == null ? Optional.empty() : Optional.of(value(argument(type, 0), given, path));
    }
    return given == null ? nothing(raw, path) : some(type, raw, given, path);
  }

  private Object nothing(Class<?> raw, String path) throws ScriptFailure {
    if (raw.isPrimitive()) {
      return raw == boolean.class ? (Object) false : number(raw, 0, path);
    }
    if (raw == String.class) {
      return "";
    }
    Optional<Object> constant = constant(raw);
    if (constant.isPresent()) {
      return constant.get();
    }
    if (raw.isAssignableFrom(List.class) || raw == List.class) {
      return List.of();
    }
    return raw == Set.class ? Set.of()
        : raw == Map.class ? Map.of()
            : raw == FrameId.class ? new FrameId(robot, "")
                : record(raw, Map.of(), path);
  }

  /** What the type itself has for nothing. */
  private static Optional<Object> constant(Class<?> type) {
    for (String name : List.of("ZERO", "IDENTITY", "EMPTY", "NONE")) {
      try {
        Field field = type.getField(name);
        if (Modifier.isStatic(field.getModifiers()) && type.isAssignableFrom(field.getType())) {
          return Optional.of(field.get(null));
        }
      } catch (NoSuchFieldException | IllegalAccessException e) {
        continue; // it has no such constant
      }
    }
    return Optional.empty();
  }

  private Object some(Type type, Class<?> raw, Object given, String path) throws ScriptFailure {
    if (raw.isPrimitive() && given instanceof Number number) {
      return number(raw, number.doubleValue(), path);
    }
    if (raw.isEnum() && given instanceof String word) {
      return word(raw, word, path);
    }
    if (raw == FrameId.class && given instanceof String name) {
      return frame(name);
    }
    if (raw == Quaternion.class && given instanceof Map<?, ?> angles && ANGLES.containsAll(angles.keySet())) {
      return Quaternion.fromRollPitchYaw(angle(angles, "roll", path), angle(angles, "pitch", path),
          angle(angles, "yaw", path));
    }
    if (given instanceof List<?> items && (raw == List.class || raw == Set.class || raw == Doubles.class)) {
      return items(type, raw, items, path);
    }
    if (given instanceof Map<?, ?> fields && raw != Map.class) {
      return record(raw, fields, path);
    }
    if (raw.isInstance(given) || raw == boolean.class && given instanceof Boolean) {
      return given;
    }
    throw new ScriptFailure(path + " must be " + noun(raw) + ", not " + given);
  }

  private static Object number(Class<?> raw, double value, String path) throws ScriptFailure {
    if (raw == double.class) {
      return value;
    }
    if (raw == float.class) {
      return (float) value;
    }
    if (value != Math.rint(value) || Math.abs(value) > (raw == long.class ? 1L << 53 : Integer.MAX_VALUE)) {
      throw new ScriptFailure(path + " must be a whole number, not " + value);
    }
    return raw == long.class ? (Object) (long) value : (Object) (int) value;
  }

  private static Object word(Class<?> raw, String word, String path) throws ScriptFailure {
    return Stream.of(raw.getEnumConstants()).filter(c -> ((Enum<?>) c).name().equalsIgnoreCase(word)).findFirst()
        .orElseThrow(() -> new ScriptFailure(path + " must be " + noun(raw) + ", not '" + word + "'"));
  }

  private FrameId frame(String name) {
    int colon = name.indexOf(':');
    return colon > 0 ? new FrameId(name.substring(0, colon), name.substring(colon + 1)) : new FrameId(robot, name);
  }

  private static double angle(Map<?, ?> angles, String name, String path) throws ScriptFailure {
    Object given = angles.containsKey(name) ? angles.get(name) : 0.0;
    if (!(given instanceof Number number)) {
      throw new ScriptFailure(path + "." + name + " must be a number, not " + given);
    }
    return number.doubleValue();
  }

  private Object items(Type type, Class<?> raw, List<?> given, String path) throws ScriptFailure {
    List<Object> made = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      Type item = raw == Doubles.class ? double.class : argument(type, 0);
      made.add(value(item, given.get(i), path + "[" + i + "]"));
    }
    if (raw == Doubles.class) {
      return Doubles.wrap(made.stream().mapToDouble(n -> (Double) n).toArray());
    }
    return raw == Set.class ? new LinkedHashSet<>(made) : made;
  }

  private static String noun(Class<?> raw) {
    if (raw.isEnum()) {
      return "one of " + Stream.of(raw.getEnumConstants())
          .map(c -> ((Enum<?>) c).name().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "));
    }
    return raw.isPrimitive() ? raw == boolean.class ? "true or false" : "a number"
        : raw == String.class ? "a text" : raw.isRecord() ? "an object (" + raw.getSimpleName() + ")" : "a list";
  }

  private static Class<?> raw(Type type) {
    return type instanceof ParameterizedType p ? (Class<?>) p.getRawType()
        : type instanceof Class<?> c ? c
            : Object.class;
  }

  private static Type argument(Type type, int index) {
    return type instanceof ParameterizedType p ? p.getActualTypeArguments()[index] : Object.class;
  }
}
