package org.robotui.data.record;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * One field of a record type. It is read by method handles, as plots read millions of values and reflection would take
 * most of their time. They go with the type, which alone holds them.
 */
final class RecordField {
  private static final MethodType OBJECT = MethodType.methodType(Object.class, Record.class);
  private static final MethodType NUMBER = MethodType.methodType(double.class, Record.class);

  private final Class<?> type;
  private final String name;
  private final boolean isNumber;
  private final MethodHandle object;
  private final MethodHandle number;

  private RecordField(Method accessor, MethodHandle reader) {
    Class<?> returned = reader.type().returnType();
    this.type = accessor.getDeclaringClass();
    this.name = accessor.getName();
    this.isNumber = returned.isPrimitive() && returned != boolean.class && returned != char.class;
    this.object = reader.asType(OBJECT);
    this.number = isNumber ? reader.asType(NUMBER) : MethodHandles.empty(NUMBER);
  }

  /** The field that a method of the type reads. */
  static RecordField of(Method accessor) {
    try {
      return new RecordField(accessor, MethodHandles.lookup().unreflect(accessor));
    } catch (IllegalAccessException e) {
      MethodHandle told = MethodHandles.throwException(Object.class, IllegalAccessException.class).bindTo(e);
      return new RecordField(accessor, MethodHandles.dropArguments(told, 0, Record.class));
    }
  }

  Class<?> type() {
    return type;
  }

  /** Whether it holds a number that is no object. */
  boolean isNumber() {
    return isNumber;
  }

  /** The value as a field; a text that says so where it cannot be read. */
  Optional<FieldValue> value(Record record) {
    try {
      return PlainValue.of((Object) object.invokeExact(record));
    } catch (Throwable e) { // of an accessor that somebody wrote
      return Optional.of(new FieldValue.Text("(" + name + " cannot be read: " + e.getMessage() + ")"));
    }
  }

  /** The value as it is; null where it cannot be read. */
  Object raw(Record record) {
    try {
      return (Object) object.invokeExact(record);
    } catch (Throwable e) {
      return null; // who asks for its field is told
    }
  }

  /** The number that it holds; none where it cannot be read. */
  OptionalDouble number(Record record) {
    try {
      return OptionalDouble.of((double) number.invokeExact(record));
    } catch (Throwable e) {
      return OptionalDouble.empty();
    }
  }
}
