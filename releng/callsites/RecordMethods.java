package callsites;

import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Equality and hash codes of records, with the same results as those of {@link java.lang.runtime.ObjectMethods}. */
final class RecordMethods {
  private static final Type OBJECT = Type.getType(Object.class);

  private static final int FACTOR = 31;

  private RecordMethods() {}

  /** Of a record and an object: whether both are the same in all fields. */
  static void writeEquals(MethodVisitor code, String record, Handle[] fields) {
    Label differs = new Label();
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitTypeInsn(Opcodes.INSTANCEOF, record);
    code.visitJumpInsn(Opcodes.IFEQ, differs);
    for (Handle field : fields) {
      get(code, field);
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitTypeInsn(Opcodes.CHECKCAST, record);
      code.visitFieldInsn(Opcodes.GETFIELD, field.getOwner(), field.getName(), field.getDesc());
      compare(code, Type.getType(field.getDesc()), differs);
    }
    code.visitInsn(Opcodes.ICONST_1);
    code.visitInsn(Opcodes.IRETURN);
    code.visitLabel(differs);
    code.visitFrame(Opcodes.F_SAME, 0, null, 0, null);
    code.visitInsn(Opcodes.ICONST_0);
  }

  static void writeHashCode(MethodVisitor code, Handle[] fields) {
    code.visitInsn(Opcodes.ICONST_0);
    for (Handle field : fields) {
      code.visitIntInsn(Opcodes.BIPUSH, FACTOR);
      code.visitInsn(Opcodes.IMUL);
      get(code, field);
      Type type = Type.getType(field.getDesc());
      if (Conversion.isReference(type)) {
        call(code, "java/util/Objects", "hashCode", Type.INT_TYPE, OBJECT);
      } else {
        call(code, Conversion.boxOf(type), "hashCode", Type.INT_TYPE, type);
      }
      code.visitInsn(Opcodes.IADD);
    }
  }

  private static void get(MethodVisitor code, Handle field) {
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitFieldInsn(Opcodes.GETFIELD, field.getOwner(), field.getName(), field.getDesc());
  }

  private static void compare(MethodVisitor code, Type type, Label differs) {
    if (Conversion.isReference(type)) {
      call(code, "java/util/Objects", "equals", Type.BOOLEAN_TYPE, OBJECT, OBJECT);
      code.visitJumpInsn(Opcodes.IFEQ, differs);
    } else {
      call(code, Conversion.boxOf(type), "compare", Type.INT_TYPE, type, type);
      code.visitJumpInsn(Opcodes.IFNE, differs);
    }
  }

  private static void call(MethodVisitor code, String owner, String name, Type result, Type... arguments) {
    code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, name, Type.getMethodDescriptor(result, arguments), false);
  }
}
