package org.robotui.message;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes what reads a record: the code that one would write by hand, the reads of all fields in the order of the
 * definition and a call of the constructor. The virtual machine runs it at once and compiles it when it is used often.
 */
final class ReadPlan {

  private final Class<?> reader;
  private final MethodHandles.Lookup lookup;
  /**
   * By the layouts themselves, each of which is made once for a schema: to compare what they hold takes longer than all
   * the rest.
   */
  private final Map<Layout, Map<Class<?>, BoundReader>> done = new IdentityHashMap<>();

  ReadPlan(Class<?> reader, MethodHandles.Lookup lookup) {
    this.reader = reader;
    this.lookup = lookup;
  }

  /**
   * What reads a record.
   *
   * @param layout of the messages
   * @param own of the version that the record is made for, by which fields are filled that the messages lack
   */
  BoundReader of(Class<?> type, Layout layout, Layout own) {
    done.putIfAbsent(layout, new HashMap<>());
    Map<Class<?>, BoundReader> records = done.get(layout);
    BoundReader known = records.get(type);
    if (known == null) {
      known = new Code(type).compile(layout, own);
      records.put(type, known);
    }
    return known;
  }

  /** The code for one record and those in it. */
  private final class Code {

    private static final int ARGUMENT = 1;
    private static final String OBJECT = "(Lorg/robotui/message/FieldReader;)Ljava/lang/Object;";

    private final Class<?> top;
    private final Parts parts;
    private final ClassCode code = new ClassCode(BoundReader.class, 2);
    private final int in = code.local(Object.class);

    Code(Class<?> top) {
      this.top = top;
      this.parts = new Parts(code, BoundReader.class);
    }

    BoundReader compile(Layout layout, Layout own) {
      code.load(Object.class, ARGUMENT);
      code.type(ClassCode.CAST, reader);
      code.store(Object.class, in);
      record(top, layout, own, "");
      code.op(ClassCode.ARETURN);
      return new Hidden(lookup).make(top, code.bytes(top, "read", OBJECT), BoundReader.class, parts.all());
    }

    private void record(Class<?> type, Layout layout, Layout own, String path) {
      BoundRecord bound = BoundRecord.of(type, layout, layout == own);
      new Hidden(lookup).check(top, type);
      RecordComponent[] components = type.getRecordComponents();
      int[] places = new int[components.length];
      for (int each : bound.absent()) {
        missing(components[each], own);
        places[each] = keep(components[each].getType());
      }
      for (BoundRecord.BoundField each : bound.fields()) {
        if (each.component().isEmpty()) {
          parts.load(skip(each.field(), path), BoundReader.class);
          read();
          code.op(ClassCode.POP);
        } else {
          value(each.component().get(), each.field(), own, path);
          places[each.index()] = keep(components[each.index()].getType());
        }
      }
      construct(type, components, places);
    }

    private int keep(Class<?> type) {
      int place = code.local(type);
      code.store(type, place);
      return place;
    }

    private void construct(Class<?> type, RecordComponent[] components, int[] places) {
      code.type(ClassCode.NEW, type);
      code.op(ClassCode.DUP);
      for (int i = 0; i < places.length; i++) {
        code.load(components[i].getType(), places[i]);
      }
      Class<?>[] types = new Class<?>[components.length];
      for (int i = 0; i < types.length; i++) {
        types[i] = components[i].getType();
      }
      code.call(ClassCode.SPECIAL, ClassCode.name(type), "<init>",
          MethodType.methodType(void.class, types).descriptorString());
    }

    private void missing(RecordComponent component, Layout own) {
      if (component.getType().isPrimitive()) {
        code.zero(component.getType());
      } else {
        parts.load(new Nothing(lookup).of(component, BoundRecord.field(own, component)), component.getType());
      }
    }

    private static BoundReader skip(Layout.Field field, String path) {
      return new Step(path, new Passed(field));
    }

    private void value(RecordComponent component, Layout.Field field, Layout own, String path) {
      Class<?> type = component.getType();
      if (field.nested() != null && !field.type().isArray()) {
        record(type, field.nested(), BoundRecord.field(own, component).nested(), path + field.name() + ".");
      } else if (field.type().textBound() > 0) {
        part(new Step(path, bounded(field)), type);
      } else if (field.nested() != null && type == List.class) {
        part(new Step(path, list(component, field, own)), type);
      } else {
        code.load(Object.class, in);
        code.text(path + field.name());
        direct(field, type);
      }
    }

    private void direct(Layout.Field field, Class<?> type) {
      String result = type.descriptorString();
      if (!field.type().isArray()) {
        code.call(ClassCode.VIRTUAL, ClassCode.name(reader), single(field.primitive()),
            "(Ljava/lang/String;)" + result);
        return;
      }
      code.number(LengthBounds.of(field.type()));
      if (type == List.class) {
        code.call(ClassCode.VIRTUAL, ClassCode.name(reader), field.primitive().rosName() + "s",
            "(Ljava/lang/String;I)" + result);
        return;
      }
      code.number(field.nested() == null ? 1 : JavaForm.flat(field.nested()).orElseThrow().width());
      code.call(ClassCode.VIRTUAL, ClassCode.name(reader), array(type), "(Ljava/lang/String;II)" + result);
    }

    private void part(BoundReader part, Class<?> type) {
      parts.load(part, BoundReader.class);
      read();
      code.type(ClassCode.CAST, type);
    }

    private void read() {
      code.load(Object.class, ARGUMENT);
      code.call(ClassCode.VIRTUAL, ClassCode.name(BoundReader.class), "read", OBJECT);
    }

    private Reading list(RecordComponent component, Layout.Field field, Layout own) {
      BoundReader element =
          of(JavaForm.element(component).orElseThrow(), field.nested(), BoundRecord.field(own, component).nested());
      return new Elements(new ListReader(element, field.name(), LengthBounds.of(field.type()), field.element()));
    }
  }

  private static Reading bounded(Layout.Field field) {
    int most = field.type().textBound();
    int length = LengthBounds.of(field.type());
    boolean wide = field.primitive() == Primitive.WSTRING;
    String name = field.name();
    return field.type().isArray()
        ? in -> LengthBounds.texts(wide ? in.wstrings(name, length) : in.strings(name, length), most, name)
        : in -> LengthBounds.text(wide ? in.wstring(name) : in.string(name), most, name);
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

  /** A part of the code that is written in Java. */
  @FunctionalInterface
  private interface Reading {
    Object read(FieldReader in) throws MessageException;
  }

  /**
   * Fields without a component; like all that most messages need a class of its own, as a lambda is linked at each
   * start.
   */
  private record Passed(Layout.Field field) implements Reading {
    @Override
    public Object read(FieldReader in) throws MessageException {
      Skip.field(field, in);
      return field;
    }
  }

  private record Elements(ListReader list) implements Reading {
    @Override
    public Object read(FieldReader in) throws MessageException {
      return list.read(in);
    }
  }

  /** Runs a part within a record that is read in place: errors name the fields that lead to it. */
  private static final class Step extends BoundReader {

    private final String path;
    private final Reading reading;

    Step(String path, Reading reading) {
      super(new Object[0]);
      this.path = path;
      this.reading = reading;
    }

    @Override
    public Object read(FieldReader in) throws MessageException {
      try {
        return reading.read(in);
      } catch (MessageException e) {
        throw path.isEmpty() ? e : e.within(path.substring(0, path.length() - 1));
      }
    }
  }
}
