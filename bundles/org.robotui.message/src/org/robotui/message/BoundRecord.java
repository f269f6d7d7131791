package org.robotui.message;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Which component of a record holds which field of a message. They have the same name but for case and underscores
 * ({@code frameId} holds {@code frame_id}). Fields that the record leaves out are passed over.
 *
 * @param type the record
 * @param fields in the order of the definition
 * @param absent the components that no field fills
 */
record BoundRecord(Class<?> type, List<BoundField> fields, List<Integer> absent) {

  /**
   * A field and what holds it.
   *
   * @param field the field
   * @param index of the component, -1 if none holds it
   * @param component what holds it
   */
  record BoundField(Layout.Field field, int index, Optional<RecordComponent> component) {}

  /**
   * Compares a record with a message.
   *
   * @param strict whether each component needs a field
   * @throws IllegalArgumentException if a component has another type than its field, or lacks one
   */
  static BoundRecord of(Class<?> type, Layout layout, boolean strict) {
    List<RecordComponent> components = List.of(type.getRecordComponents());
    List<String> names = plainNames(components);
    List<BoundField> fields = new ArrayList<>();
    List<Integer> absent = new ArrayList<>();
    for (int i = 0; i < components.size(); i++) {
      absent.add(i);
    }
    for (Layout.Field each : layout.fields()) {
      int index = names.indexOf(plain(each.name()));
      if (index < 0) {
        fields.add(new BoundField(each, index, Optional.empty()));
        continue;
      }
      RecordComponent holder = components.get(index);
      Optional<String> misfit = JavaForm.misfit(holder, each);
      if (misfit.isPresent()) {
        throw new IllegalArgumentException(place(type, holder, layout) + misfit.get());
      }
      absent.remove((Object) index);
      fields.add(new BoundField(each, index, Optional.of(holder)));
    }
    if (strict && !absent.isEmpty()) {
      throw new IllegalArgumentException(place(type, components.get(absent.getFirst()), layout)
          + "is no field; there are " + layout.fields().stream().map(Layout.Field::name).toList());
    }
    return new BoundRecord(type, fields, absent);
  }

  private static List<String> plainNames(List<RecordComponent> components) {
    List<String> names = new ArrayList<>();
    for (RecordComponent each : components) {
      names.add(plain(each.getName()));
    }
    return names;
  }

  private static String place(Class<?> type, RecordComponent component, Layout layout) {
    return type.getName() + " for " + layout.type() + ": component " + component.getName() + " ";
  }

  private static String plain(String name) {
    return name.replace("_", "").toLowerCase(Locale.ROOT);
  }

  /** The field that a component of a record is made for. */
  static Layout.Field field(Layout own, RecordComponent component) {
    String name = plain(component.getName());
    for (Layout.Field each : own.fields()) {
      if (plain(each.name()).equals(name)) {
        return each;
      }
    }
    throw new IllegalArgumentException(own.type() + " has no field for " + component);
  }

  static MethodHandle constructor(MethodHandles.Lookup lookup, Class<?> type) {
    try {
      return lookup.unreflectConstructor(type.getDeclaredConstructor(
          Arrays.stream(type.getRecordComponents()).map(RecordComponent::getType).toArray(Class<?>[]::new)));
    } catch (NoSuchMethodException | IllegalAccessException e) {
      throw new IllegalArgumentException(type.getName() + " cannot be made here: " + e.getMessage(), e);
    }
  }
}
