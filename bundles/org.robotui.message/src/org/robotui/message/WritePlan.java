package org.robotui.message;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Puts a method handle together that writes a record, field by field in the order of the definition. */
final class WritePlan {

  private static final MethodHandle ZERO =
      Handles.function(ArrayWriter.class, "zero", void.class, Layout.Field.class, FieldWriter.class);

  private final Class<?> writer;
  private final MethodHandles.Lookup lookup;
  private final Map<BoundRecord, MethodHandle> done = new HashMap<>();

  WritePlan(Class<?> writer, MethodHandles.Lookup lookup) {
    this.writer = writer;
    this.lookup = lookup;
  }

  /** A handle from the record and the writer to nothing. */
  MethodHandle of(Class<?> type, Layout layout) {
    BoundRecord bound = BoundRecord.of(type, layout, false);
    MethodHandle known = done.get(bound);
    if (known == null) {
      known = compose(bound);
      done.put(bound, known);
    }
    return known;
  }

  /** What is put in front last is done first, so the last field comes first. */
  private MethodHandle compose(BoundRecord bound) {
    MethodHandle plan = MethodHandles.empty(MethodType.methodType(void.class, bound.type(), writer));
    for (BoundRecord.BoundField each : bound.fields().reversed()) {
      plan = MethodHandles.foldArguments(plan, field(bound.type(), each));
    }
    return plan;
  }

  private MethodHandle field(Class<?> type, BoundRecord.BoundField bound) {
    if (bound.component().isEmpty()) {
      MethodHandle zero = ZERO.bindTo(bound.field()).asType(MethodType.methodType(void.class, writer));
      return MethodHandles.dropArguments(zero, 0, type);
    }
    RecordComponent component = bound.component().get();
    return MethodHandles.filterArguments(value(component, bound.field()), 0, BoundRecord.accessor(lookup, component));
  }

  private MethodHandle value(RecordComponent component, Layout.Field field) {
    Class<?> type = component.getType();
    MethodType taking = MethodType.methodType(void.class, type, writer);
    if (field.type().isArray()) {
      return array(component, field).asType(taking);
    }
    return field.nested() != null ? of(type, field.nested()) : single(field.primitive(), taking);
  }

  private MethodHandle array(RecordComponent component, Layout.Field field) {
    int length = Bounds.of(field.type());
    if (component.getType() == List.class && field.nested() != null) {
      MethodHandle one = of(JavaForm.element(component).orElseThrow(), field.nested())
          .asType(MethodType.methodType(void.class, Object.class, FieldWriter.class));
      ListWriter list = new ListWriter(one, field.name(), length);
      return Handles.method(ListWriter.class, "write", void.class, List.class, FieldWriter.class).bindTo(list);
    }
    int width = field.nested() == null ? 1 : JavaForm.flat(field.nested()).orElseThrow().width();
    return Handles.method(
        ArrayWriter.class, "write", void.class, component.getType(), FieldWriter.class)
        .bindTo(new ArrayWriter(field.name(), length, width));
  }

  private MethodHandle single(Primitive type, MethodType taking) {
    MethodHandle method = switch (type) {
      case BOOL -> writes("bool", boolean.class);
      case INT8, UINT8, BYTE, CHAR -> writes("u8", int.class);
      case INT16, UINT16 -> writes("i16", int.class);
      case INT32, UINT32 -> writes("i32", int.class);
      case INT64, UINT64 -> writes("i64", long.class);
      case FLOAT32 -> writes("f32", float.class);
      case FLOAT64 -> writes("f64", double.class);
      case STRING -> writes("string", String.class);
      case WSTRING -> writes("wstring", String.class);
      case TIME, DURATION -> writes("stamp", long.class);
    };
    return MethodHandles.explicitCastArguments(method, taking);
  }

  private MethodHandle writes(String name, Class<?> value) {
    MethodHandle method = MethodHandles.dropReturn(Handles.method(writer, name, FieldWriter.class, value));
    return MethodHandles.permuteArguments(method, MethodType.methodType(void.class, value, writer), 1, 0);
  }
}
