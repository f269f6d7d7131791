package callsites;

import java.util.stream.Stream;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;

/** The number of the first case from a given one on that an object belongs to, as the language's switch asks for it. */
final class TypeSwitch {
  private TypeSwitch() {}

  static boolean isPlain(InvokeDynamicInsnNode site) {
    return Stream.of(site.bsmArgs).allMatch(label -> label instanceof Type || label instanceof String);
  }

  /** Leaves -1 for null, and the number of cases where none fits. */
  static void write(MethodVisitor code, InvokeDynamicInsnNode site) {
    Label isThere = new Label();
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitJumpInsn(Opcodes.IFNONNULL, isThere);
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitInsn(Opcodes.IRETURN);
    begin(code, isThere);
    for (int i = 0; i < site.bsmArgs.length; i++) {
      Label next = new Label();
      test(code, site.bsmArgs[i]);
      code.visitJumpInsn(Opcodes.IFEQ, next);
      code.visitVarInsn(Opcodes.ILOAD, 1);
      code.visitIntInsn(Opcodes.SIPUSH, i);
      code.visitJumpInsn(Opcodes.IF_ICMPGT, next);
      code.visitIntInsn(Opcodes.SIPUSH, i);
      code.visitInsn(Opcodes.IRETURN);
      begin(code, next);
    }
    code.visitIntInsn(Opcodes.SIPUSH, site.bsmArgs.length);
  }

  private static void test(MethodVisitor code, Object label) {
    if (label instanceof Type type) {
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitTypeInsn(Opcodes.INSTANCEOF, type.getInternalName());
    } else {
      code.visitLdcInsn(label);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/lang/String", "equals", "(Ljava/lang/Object;)Z", false);
    }
  }

  private static void begin(MethodVisitor code, Label label) {
    code.visitLabel(label);
    code.visitFrame(Opcodes.F_SAME, 0, null, 0, null);
  }
}
