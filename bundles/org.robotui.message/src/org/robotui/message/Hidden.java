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
      MethodHandles.Lookup made = define(neighbour, code);
      MethodHandle constructor =
          made.findConstructor(made.lookupClass(), MethodType.methodType(void.class, Object[].class));
      return type.cast(constructor.asType(MethodType.methodType(Object.class, Object[].class)).invokeExact(parts));
    } catch (IllegalAccessException | LinkageError e) {
      throw new IllegalArgumentException(neighbour.getName() + " cannot be bound: " + e.getMessage(), e);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * A class of another bundle cannot be given hidden neighbours, as each bundle is a module of its own. A loader below
   * its own sees all that is public there.
   */
  private static MethodHandles.Lookup define(Class<?> neighbour, byte[] code) throws IllegalAccessException {
    MethodHandles.Lookup beside = MethodHandles.privateLookupIn(neighbour, HERE);
    if (beside.hasFullPrivilegeAccess()) {
      return beside.defineHiddenClass(code, true, MethodHandles.Lookup.ClassOption.NESTMATE);
    }
    return MethodHandles.privateLookupIn(new Below(neighbour.getClassLoader()).define(code), HERE);
  }

  /** The loader of one class, with which it goes. */
  private static final class Below extends ClassLoader {
    Below(ClassLoader above) {
      super(above);
    }

    Class<?> define(byte[] code) {
      return defineClass(null, code, 0, code.length);
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
