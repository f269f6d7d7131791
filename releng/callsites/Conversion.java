package callsites;

import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import java.util.stream.Collectors;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Values of one type as values of another, as the language converts arguments and results of lambdas. */
final class Conversion {
  private static final Type OBJECT = Type.getType(Object.class);

  private static final Map<Type, Type> BOXES = Map.of(Type.BOOLEAN_TYPE, Type.getType(Boolean.class), Type.BYTE_TYPE,
      Type.getType(Byte.class), Type.CHAR_TYPE, Type.getType(Character.class), Type.SHORT_TYPE,
      Type.getType(Short.class), Type.INT_TYPE, Type.getType(Integer.class), Type.LONG_TYPE, Type.getType(Long.class),
      Type.FLOAT_TYPE, Type.getType(Float.class), Type.DOUBLE_TYPE, Type.getType(Double.class));

  private static final Map<Type, Type> UNBOXED = BOXES.entrySet().stream()
      .collect(Collectors.toMap(Entry::getValue, Entry::getKey));

  private static final Map<Type, List<Type>> WIDER = Map.of(
      Type.BYTE_TYPE, List.of(Type.SHORT_TYPE, Type.INT_TYPE, Type.LONG_TYPE, Type.FLOAT_TYPE, Type.DOUBLE_TYPE),
      Type.SHORT_TYPE, List.of(Type.INT_TYPE, Type.LONG_TYPE, Type.FLOAT_TYPE, Type.DOUBLE_TYPE),
      Type.CHAR_TYPE, List.of(Type.INT_TYPE, Type.LONG_TYPE, Type.FLOAT_TYPE, Type.DOUBLE_TYPE),
      Type.INT_TYPE, List.of(Type.LONG_TYPE, Type.FLOAT_TYPE, Type.DOUBLE_TYPE),
      Type.LONG_TYPE, List.of(Type.FLOAT_TYPE, Type.DOUBLE_TYPE),
      Type.FLOAT_TYPE, List.of(Type.DOUBLE_TYPE));

  private Conversion() {}

  static boolean isReference(Type type) {
    return type.getSort() == Type.OBJECT || type.getSort() == Type.ARRAY;
  }

  /** The class of boxes of a primitive type. */
  static String boxOf(Type primitive) {
    return BOXES.get(primitive).getInternalName();
  }

  static boolean isPossible(Type from, Type to) {
    if (to.equals(Type.VOID_TYPE) || from.equals(to)) {
      return true;
    }
    if (from.equals(Type.VOID_TYPE)) {
      return false;
    }
    if (isReference(to)) {
      return true;
    }
    Type value = isReference(from) ? UNBOXED.get(from) : from;
    return value != null && (value.equals(to) || isWidening(value, to));
  }

  static void emit(MethodVisitor code, Type from, Type to) {
    if (to.equals(Type.VOID_TYPE)) {
      drop(code, from);
    } else if (!isReference(to)) {
      emitPrimitive(code, from, to);
    } else if (!isReference(from)) {
      Type box = BOXES.get(from);
      code.visitMethodInsn(Opcodes.INVOKESTATIC, box.getInternalName(), "valueOf",
          Type.getMethodDescriptor(box, from), false);
      cast(code, box, to);
    } else {
      cast(code, from, to);
    }
  }

  private static void drop(MethodVisitor code, Type from) {
    if (from.getSize() > 0) {
      code.visitInsn(from.getSize() == 1 ? Opcodes.POP : Opcodes.POP2);
    }
  }

  /** A cast also where a value is of that type anyway: else the verifier would load both types to find that out. */
  private static void cast(MethodVisitor code, Type from, Type to) {
    if (!to.equals(from) && !to.equals(OBJECT)) {
      code.visitTypeInsn(Opcodes.CHECKCAST, to.getInternalName());
    }
  }

  private static void emitPrimitive(MethodVisitor code, Type from, Type to) {
    Type value = from;
    if (isReference(from)) {
      value = UNBOXED.get(from);
      code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, from.getInternalName(), value.getClassName() + "Value",
          Type.getMethodDescriptor(value), false);
    }
    widen(code, value, to);
  }

  private static boolean isWidening(Type from, Type to) {
    return WIDER.getOrDefault(from, List.of()).contains(to);
  }

  private static void widen(MethodVisitor code, Type from, Type to) {
    boolean isInt = from.getSort() <= Type.INT;
    if (to.equals(Type.LONG_TYPE) && isInt) {
      code.visitInsn(Opcodes.I2L);
    } else if (to.equals(Type.FLOAT_TYPE) && !from.equals(to)) {
      code.visitInsn(isInt ? Opcodes.I2F : Opcodes.L2F);
    } else if (to.equals(Type.DOUBLE_TYPE) && !from.equals(to)) {
      code.visitInsn(isInt ? Opcodes.I2D : from.equals(Type.LONG_TYPE) ? Opcodes.L2D : Opcodes.F2D);
    }
  }
}
