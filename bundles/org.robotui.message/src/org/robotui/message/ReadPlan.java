package org.robotui.message;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Puts a method handle together that reads a record: the reads of all fields in the order of the definition, handed to
 * the constructor. The virtual machine compiles it like a method that was written by hand.
 */
final class ReadPlan {

  private record Key(Class<?> record, Layout layout) {}

  private static final MethodHandle SKIP =
      Handles.function(Skip.class, "field", void.class, Layout.Field.class, FieldReader.class);
  private static final MethodHandle WITHIN =
      Handles.method(MessageException.class, "within", MessageException.class, String.class);

  private final Class<?> reader;
  private final MethodHandles.Lookup lookup;
  private final Map<Key, MethodHandle> done = new HashMap<>();

  ReadPlan(Class<?> reader, MethodHandles.Lookup lookup) {
    this.reader = reader;
    this.lookup = lookup;
  }

  /**
   * A handle from the reader to the record.
   *
   * @param layout of the messages
   * @param own of the version that the record is made for, by which fields are filled that the messages lack
   */
  MethodHandle of(Class<?> type, Layout layout, Layout own) {
    Key key = new Key(type, layout);
    MethodHandle known = done.get(key);
    if (known == null) {
      known = compose(BoundRecord.of(type, layout, layout.equals(own)), own);
      done.put(key, known);
    }
    return known;
  }

  /** What is put in front last is done first, so the last field comes first. */
  private MethodHandle compose(BoundRecord bound, Layout own) {
    MethodHandle plan = BoundRecord.constructor(lookup, bound.type());
    RecordComponent[] components = bound.type().getRecordComponents();
    for (int each : bound.absent()) {
      Object zero = new Nothing(lookup).of(components[each], BoundRecord.field(own, components[each]));
      MethodHandle nothing = MethodHandles.constant(components[each].getType(), zero);
      plan = MethodHandles.collectArguments(plan, each, MethodHandles.dropArguments(nothing, 0, reader));
    }
    for (BoundRecord.BoundField each : bound.fields().reversed()) {
      plan = each.component().isPresent()
          ? MethodHandles.collectArguments(plan, each.index(), value(each.component().get(), each.field(), own))
          : MethodHandles.collectArguments(plan, plan.type().parameterCount(), skip(each.field()));
    }
    MethodType whole = MethodType.methodType(bound.type(), reader);
    return MethodHandles.permuteArguments(plan, whole, new int[plan.type().parameterCount()]);
  }

  private MethodHandle skip(Layout.Field field) {
    return SKIP.bindTo(field).asType(MethodType.methodType(void.class, reader));
  }

  private MethodHandle value(RecordComponent component, Layout.Field field, Layout own) {
    Class<?> type = component.getType();
    Layout ownNested = BoundRecord.field(own, component).nested();
    if (field.nested() != null && !field.type().isArray()) {
      return named(of(type, field.nested(), ownNested), field.name());
    }
    if (!field.type().isArray()) {
      return bounded(bind(Handles.method(reader, single(field.primitive()), type, String.class), field.name()), field);
    }
    int length = Bounds.of(field.type());
    if (type != List.class) {
      int width = field.nested() == null ? 1 : JavaForm.flat(field.nested()).orElseThrow().width();
      return bind(Handles.method(reader, array(type), type, String.class, int.class, int.class), field.name(), length,
          width);
    }
    if (field.nested() == null) {
      String texts = field.primitive().rosName() + "s";
      return bounded(bind(Handles.method(reader, texts, type, String.class, int.class), field.name(), length), field);
    }
    return list(of(JavaForm.element(component).orElseThrow(), field.nested(), ownNested), field, length);
  }

  /** Texts are checked against the bound of their definition, where it has one. */
  private static MethodHandle bounded(MethodHandle read, Layout.Field field) {
    int most = field.type().textBound();
    if (most == 0) {
      return read;
    }
    Class<?> type = read.type().returnType();
    String check = type == List.class ? "texts" : "text";
    return MethodHandles.filterReturnValue(read, MethodHandles.insertArguments(
        Handles.function(Bounds.class, check, type, type, int.class, String.class), 1, most, field.name()));
  }

  private MethodHandle list(MethodHandle element, Layout.Field field, int length) {
    MethodHandle one = element.asType(MethodType.methodType(Object.class, FieldReader.class));
    ListReader list = new ListReader(one, field.name(), length, field.element());
    return Handles.method(ListReader.class, "read", List.class, FieldReader.class).bindTo(list)
        .asType(MethodType.methodType(List.class, reader));
  }

  private static MethodHandle bind(MethodHandle method, Object... arguments) {
    return MethodHandles.insertArguments(method, 1, arguments);
  }

  /** Errors of a nested message name the field that holds it. */
  private static MethodHandle named(MethodHandle nested, String field) {
    MethodHandle fail = MethodHandles.throwException(nested.type().returnType(), MessageException.class);
    MethodHandle within = MethodHandles.insertArguments(WITHIN, 1, field);
    return MethodHandles.catchException(
        nested, MessageException.class, MethodHandles.filterArguments(fail, 0, within));
  }

  private static String single(Primitive type) {
    return switch (type) {
      case BYTE -> "int8";
      case CHAR -> "uint8";
      default -> type.rosName();
    };
  }

  private static String array(Class<?> type) {
    return type.isArray() ? type.componentType().getName() + "s" : "bytes";
  }
}
