package org.robotui.message;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Modifier;

/** Makes classes beside records, which may see what the records see. */
record Hidden(MethodHandles.Lookup lookup) {

  private static final MethodHandles.Lookup HERE = MethodHandles.lookup();

  /** An object of the class, which nobody else can name. */
  <T> T make(Class<?> neighbour, byte[] code, Class<T> type, Object[] parts) {
    try {
      MethodHandles.Lookup hidden = MethodHandles.privateLookupIn(neighbour, HERE)
          .defineHiddenClass(code, true, MethodHandles.Lookup.ClassOption.NESTMATE);
      MethodHandle constructor =
          hidden.findConstructor(hidden.lookupClass(), MethodType.methodType(void.class, Object[].class));
      return type.cast(constructor.asType(MethodType.methodType(Object.class, Object[].class)).invokeExact(parts));
    } catch (IllegalAccessException | LinkageError e) {
      throw new IllegalArgumentException(neighbour.getName() + " cannot be bound: " + e.getMessage(), e);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /** Records that are not public need somebody who may see them. */
  void check(Class<?> neighbour, Class<?> record) {
    boolean seen = Modifier.isPublic(record.getModifiers())
        || record.getPackage().equals(neighbour.getPackage())
            && record.getPackage().equals(lookup.lookupClass().getPackage())
            && (lookup.lookupModes() & MethodHandles.Lookup.PACKAGE) != 0;
    if (!seen) {
      throw new IllegalArgumentException(record.getName() + " cannot be made here: it is not public");
    }
  }
}
