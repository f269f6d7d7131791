package org.robotui.message;

import java.lang.invoke.MethodHandles;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

/** Makes what writes a record: the code that one would write by hand, field by field in the order of the definition. */
final class WritePlan {

  private final Class<?> writer;
  private final MethodHandles.Lookup lookup;
  /**
   * By the layouts themselves, each of which is made once for a schema: to compare what they hold takes longer than all
   * the rest.
   */
  private final Map<Layout, Map<Class<?>, BoundWriter>> done = new IdentityHashMap<>();

  WritePlan(Class<?> writer, MethodHandles.Lookup lookup) {
    this.writer = writer;
    this.lookup = lookup;
  }

  BoundWriter of(Class<?> type, Layout layout) {
    Map<Class<?>, BoundWriter> records = done.computeIfAbsent(layout, each -> new HashMap<>());
    BoundWriter known = records.get(type);
    if (known == null) {
      known = new Code(type).compile(layout);
      records.put(type, known);
    }
    return known;
  }

  /** The code for one record and those in it. */
  private final class Code {

    private static final int VALUE = 1;
    private static final int ARGUMENT = 2;
    private static final String VOID = "(Ljava/lang/Object;Lorg/robotui/message/FieldWriter;)V";

    private final Class<?> top;
    private final Parts parts;
    private final ClassCode code = new ClassCode(BoundWriter.class, 3);
    private final int out = code.local(Object.class);

    Code(Class<?> top) {
      this.top = top;
      this.parts = new Parts(code, BoundWriter.class);
    }

    BoundWriter compile(Layout layout) {
      code.load(Object.class, ARGUMENT);
      code.type(ClassCode.CAST, writer);
      code.store(Object.class, out);
      code.load(Object.class, VALUE);
      code.type(ClassCode.CAST, top);
      record(top, layout);
      code.op(ClassCode.RETURN);
      return new Hidden(lookup).make(top, code.bytes(top, "write", VOID), BoundWriter.class, parts.all());
    }

    /** Takes the record from the stack. */
    private void record(Class<?> type, Layout layout) {
      new Hidden(lookup).check(top, type);
      int value = code.local(type);
      code.store(type, value);
      for (BoundRecord.BoundField each : BoundRecord.of(type, layout, false).fields()) {
        if (each.component().isEmpty()) {
          Layout.Field field = each.field();
          parts.load(new Step((nothing, to) -> ArrayWriter.zero(field, to)), BoundWriter.class);
          code.load(Object.class, VALUE);
          write();
        } else {
          field(type, value, each.component().get(), each.field());
        }
      }
    }

    private void field(Class<?> type, int value, RecordComponent component, Layout.Field field) {
      boolean array = field.type().isArray();
      boolean direct = field.nested() == null && !array && field.type().textBound() == 0;
      if (direct) {
        code.load(Object.class, out);
      } else if (array || field.nested() == null) {
        parts.load(new Step(array ? array(component, field) : bounded(field)), BoundWriter.class);
      }
      code.load(type, value);
      code.call(ClassCode.VIRTUAL, ClassCode.name(type), component.getName(),
          "()" + component.getType().descriptorString());
      if (direct) {
        single(field.primitive());
      } else if (array || field.nested() == null) {
        write();
      } else {
        record(component.getType(), field.nested());
      }
    }

    private void write() {
      code.load(Object.class, ARGUMENT);
      code.call(ClassCode.VIRTUAL, ClassCode.name(BoundWriter.class), "write", VOID);
    }

    private void single(Primitive type) {
      switch (type) {
        case BOOL -> call("bool", "Z");
        case INT8, UINT8, BYTE, CHAR -> call("u8", "I");
        case INT16, UINT16 -> call("i16", "I");
        case INT32 -> call("i32", "I");
        case UINT32 -> {
          code.op(ClassCode.LONG_TO_INT);
          call("i32", "I");
        }
        case INT64, UINT64 -> call("i64", "J");
        case FLOAT32 -> call("f32", "F");
        case FLOAT64 -> call("f64", "D");
        case STRING -> call("string", "Ljava/lang/String;");
        case WSTRING -> call("wstring", "Ljava/lang/String;");
        case TIME, DURATION -> call("stamp", "J");
      }
    }

    private void call(String method, String value) {
      code.call(ClassCode.VIRTUAL, ClassCode.name(writer), method, "(" + value + ")Lorg/robotui/message/FieldWriter;");
      code.op(ClassCode.POP);
    }
  }

  private static BiConsumer<Object, FieldWriter> bounded(Layout.Field field) {
    boolean wide = field.primitive() == Primitive.WSTRING;
    return (value, out) -> {
      String text = LengthBounds.written((String) value, field.type().textBound(), field.name());
      if (wide) {
        out.wstring(text);
      } else {
        out.string(text);
      }
    };
  }

  private BiConsumer<Object, FieldWriter> array(RecordComponent component, Layout.Field field) {
    int length = LengthBounds.of(field.type());
    if (component.getType() == List.class && field.nested() != null) {
      BoundWriter one = of(JavaForm.element(component).orElseThrow(), field.nested());
      ListWriter list = new ListWriter(one, field.name(), length);
      return (value, out) -> list.write((List<?>) value, out);
    }
    ArrayWriter array =
        new ArrayWriter(field.name(), length,
            field.nested() == null ? 1 : JavaForm.flat(field.nested()).orElseThrow().width());
    return array(component.getType(), array, field);
  }

  private static BiConsumer<Object, FieldWriter> array(Class<?> type, ArrayWriter array, Layout.Field field) {
    if (type == List.class) {
      return (value, out) -> array.texts((List<?>) value, field, out);
    }
    if (type == ByteBuffer.class) {
      return (value, out) -> array.write((ByteBuffer) value, out);
    }
    return switch (type.componentType().getName()) {
      case "short" -> (value, out) -> array.write((short[]) value, out);
      case "int" -> (value, out) -> array.write((int[]) value, out);
      case "long" -> (value, out) -> array.write((long[]) value, out);
      case "float" -> (value, out) -> array.write((float[]) value, out);
      default -> (value, out) -> array.write((double[]) value, out);
    };
  }

  /** A part of the code that is written in Java. */
  private static final class Step extends BoundWriter {

    private final BiConsumer<Object, FieldWriter> writing;

    Step(BiConsumer<Object, FieldWriter> writing) {
      super(new Object[0]);
      this.writing = writing;
    }

    @Override
    public void write(Object value, FieldWriter out) {
      writing.accept(value, out);
    }
  }
}
