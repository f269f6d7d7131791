package org.robotui.message;

import java.util.ArrayList;
import java.util.List;

/** The objects that generated code refers to, kept in the field {@code parts} of its object. */
record Parts(ClassCode code, Class<?> owner, List<Object> objects) {

  private static final int THIS = 0;

  Parts(ClassCode code, Class<?> owner) {
    this(code, owner, new ArrayList<>());
  }

  Object[] all() {
    return objects.toArray();
  }

  /** Puts an object on the stack. */
  void load(Object part, Class<?> type) {
    code.load(Object.class, THIS);
    code.field(owner, "parts", "[Ljava/lang/Object;");
    code.number(objects.size());
    code.op(ClassCode.AALOAD);
    code.type(ClassCode.CAST, type);
    objects.add(part);
  }
}
