package callsites;

import java.util.List;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.ClassNode;

/** A class of the same nest in place of a lambda: what is captured are its fields, and what captures nothing is one. */
final class LambdaClass {
  static final String FACTORY = "of";

  private static final String OBJECT = "java/lang/Object";

  private static final String ONE = "ONE";

  private final String name;

  private final Type type;

  private final Lambda lambda;

  private final ClassWriter out = new ClassWriter(ClassWriter.COMPUTE_MAXS);

  private LambdaClass(String name, Lambda lambda) {
    this.name = name;
    this.type = Type.getObjectType(name);
    this.lambda = lambda;
  }

  static byte[] write(String name, Lambda lambda, ClassNode host) {
    LambdaClass written = new LambdaClass(name, lambda);
    written.write(host);
    return written.out.toByteArray();
  }

  private void write(ClassNode host) {
    out.visit(host.version, Opcodes.ACC_FINAL | Opcodes.ACC_SUPER | Opcodes.ACC_SYNTHETIC, name, null, OBJECT,
        new String[]{lambda.type().getInternalName()});
    out.visitNestHost(Access.nestOf(host));
    writeConstructor();
    writeFactory();
    lambda.signatures().forEach(this::writeMethod);
    out.visitEnd();
  }

  private void writeConstructor() {
    Type[] captured = lambda.captured();
    MethodVisitor code = begin(Opcodes.ACC_PRIVATE, "<init>", Type.getMethodDescriptor(Type.VOID_TYPE, captured));
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, "<init>", "()V", false);
    int place = 1;
    for (int i = 0; i < captured.length; i++) {
      out.visitField(Opcodes.ACC_PRIVATE | Opcodes.ACC_FINAL, field(i), captured[i].getDescriptor(), null, null);
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitVarInsn(captured[i].getOpcode(Opcodes.ILOAD), place);
      code.visitFieldInsn(Opcodes.PUTFIELD, name, field(i), captured[i].getDescriptor());
      place += captured[i].getSize();
    }
    end(code, Type.VOID_TYPE);
  }

  private void writeFactory() {
    Type[] captured = lambda.captured();
    if (captured.length == 0) {
      writeOne();
    }
    MethodVisitor code = begin(Opcodes.ACC_STATIC, FACTORY, lambda.factory().getDescriptor());
    if (captured.length == 0) {
      code.visitFieldInsn(Opcodes.GETSTATIC, name, ONE, type.getDescriptor());
    } else {
      code.visitTypeInsn(Opcodes.NEW, name);
      code.visitInsn(Opcodes.DUP);
      int place = 0;
      for (Type value : captured) {
        code.visitVarInsn(value.getOpcode(Opcodes.ILOAD), place);
        place += value.getSize();
      }
      construct(code, captured);
    }
    end(code, lambda.type());
  }

  private void writeOne() {
    out.visitField(Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL, ONE, type.getDescriptor(), null, null);
    MethodVisitor code = begin(Opcodes.ACC_STATIC, "<clinit>", "()V");
    code.visitTypeInsn(Opcodes.NEW, name);
    code.visitInsn(Opcodes.DUP);
    construct(code);
    code.visitFieldInsn(Opcodes.PUTSTATIC, name, ONE, type.getDescriptor());
    end(code, Type.VOID_TYPE);
  }

  private void construct(MethodVisitor code, Type... captured) {
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, name, "<init>", Type.getMethodDescriptor(Type.VOID_TYPE, captured),
        false);
  }

  private void writeMethod(Type signature) {
    MethodVisitor code = begin(Opcodes.ACC_PUBLIC, lambda.name(), signature.getDescriptor());
    if (lambda.isConstructor()) {
      code.visitTypeInsn(Opcodes.NEW, lambda.body().getOwner());
      code.visitInsn(Opcodes.DUP);
    }
    loadCaptured(code);
    loadArguments(code, signature.getArgumentTypes());
    call(code);
    Type concrete = lambda.concrete().getReturnType();
    Conversion.emit(code, lambda.given(), concrete);
    Type given = Conversion.isReference(concrete) && Conversion.isReference(lambda.given()) ? lambda.given() : concrete;
    Conversion.emit(code, given, signature.getReturnType());
    end(code, signature.getReturnType());
  }

  private void loadCaptured(MethodVisitor code) {
    Type[] captured = lambda.captured();
    for (int i = 0; i < captured.length; i++) {
      code.visitVarInsn(Opcodes.ALOAD, 0);
      code.visitFieldInsn(Opcodes.GETFIELD, name, field(i), captured[i].getDescriptor());
      Conversion.emit(code, captured[i], lambda.taken().get(i));
    }
  }

  private void loadArguments(MethodVisitor code, Type[] arguments) {
    Type[] concrete = lambda.concrete().getArgumentTypes();
    List<Type> taken = lambda.taken();
    int first = lambda.captured().length;
    int place = 1;
    for (int i = 0; i < arguments.length; i++) {
      code.visitVarInsn(arguments[i].getOpcode(Opcodes.ILOAD), place);
      Conversion.emit(code, arguments[i], concrete[i]);
      Conversion.emit(code, concrete[i], taken.get(first + i));
      place += arguments[i].getSize();
    }
  }

  private void call(MethodVisitor code) {
    Handle body = lambda.body();
    int operation = switch (body.getTag()) {
      case Opcodes.H_INVOKESTATIC -> Opcodes.INVOKESTATIC;
      case Opcodes.H_NEWINVOKESPECIAL -> Opcodes.INVOKESPECIAL;
      default -> body.isInterface() ? Opcodes.INVOKEINTERFACE : Opcodes.INVOKEVIRTUAL;
    };
    code.visitMethodInsn(operation, body.getOwner(), body.getName(), body.getDesc(), body.isInterface());
  }

  private static String field(int i) {
    return "captured" + i;
  }

  private MethodVisitor begin(int access, String method, String descriptor) {
    MethodVisitor code = out.visitMethod(access, method, descriptor, null, null);
    code.visitCode();
    return code;
  }

  private static void end(MethodVisitor code, Type result) {
    code.visitInsn(result.getOpcode(Opcodes.IRETURN));
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
