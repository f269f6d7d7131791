package org.robotui.player.layout;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Structures as public Java records with components of the same names in the same order: {@code min_angle} is
 * {@code minAngle}.
 */
final class RecordShape implements Shape {

  private static final Pattern JOINT = Pattern.compile("_(\\w)");

  private final Class<?> type;
  private final RecordComponent[] components;
  private final MethodHandle constructor;
  private final MethodHandle[] accessors;

  private RecordShape(Class<?> type, RecordComponent[] components, MethodHandle constructor, MethodHandle[] accessors) {
    this.type = type;
    this.components = components;
    this.constructor = constructor;
    this.accessors = accessors;
  }

  static RecordShape of(StructLayout struct, Class<?> type) {
    RecordComponent[] components = type.getRecordComponents();
    List<FieldLayout> fields = struct.fields();
    if (components == null || components.length != fields.size()) {
      throw new LayoutException(type.getName() + " does not have the fields of " + struct);
    }
    for (int i = 0; i < components.length; i++) {
      check(type, components[i], fields.get(i));
    }
    return new RecordShape(type, components, constructor(type, components), accessors(components));
  }

  private static void check(Class<?> type, RecordComponent component, FieldLayout field) {
    String name = JOINT.matcher(field.name()).replaceAll(found -> found.group(1).toUpperCase(java.util.Locale.ROOT));
    if (!component.getName().equals(name) || !fits(component.getType(), field)) {
      throw new LayoutException(type.getName() + ": the component " + component + " does not fit the field " + field);
    }
  }

  private static boolean fits(Class<?> java, FieldLayout field) {
    if (field.struct().isPresent()) {
      return field.isArray() ? java == List.class : java.isRecord();
    }
    Primitive primitive = field.primitive().orElseThrow();
    return java == (field.isArray() ? primitive.zeros(0).getClass() : primitive.java());
  }

  private static MethodHandle constructor(Class<?> type, RecordComponent[] components) {
    Class<?>[] types = Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
    try {
      return MethodHandles.publicLookup().findConstructor(type, MethodType.methodType(void.class, types))
          .asSpreader(Object[].class, types.length).asType(MethodType.methodType(Object.class, Object[].class));
    } catch (ReflectiveOperationException e) {
      throw new LayoutException(type.getName() + " cannot be made: " + e.getMessage());
    }
  }

  private static MethodHandle[] accessors(RecordComponent[] components) {
    MethodHandle[] accessors = new MethodHandle[components.length];
    for (int i = 0; i < components.length; i++) {
      try {
        accessors[i] = MethodHandles.publicLookup().unreflect(components[i].getAccessor())
            .asType(MethodType.methodType(Object.class, Object.class));
      } catch (IllegalAccessException e) {
        throw new LayoutException(components[i] + " cannot be read: " + e.getMessage());
      }
    }
    return accessors;
  }

  @Override
  public Object build(Object[] values) {
    try {
      return constructor.invokeExact(values);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(type.getName() + " refuses its values", e);
    }
  }

  @Override
  public Object[] parts(Object built) {
    Object[] values = new Object[accessors.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = part(i, built);
    }
    return values;
  }

  private Object part(int index, Object built) {
    try {
      return accessors[index].invokeExact(built);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(type.getName() + " hides " + components[index].getName(), e);
    }
  }

  @Override
  public Shape nested(int index, FieldLayout field) {
    Class<?> nested = field.isArray()
        ? (Class<?>) ((ParameterizedType) components[index].getGenericType()).getActualTypeArguments()[0]
        : components[index].getType();
    return of(field.struct().orElseThrow(), nested);
  }
}
