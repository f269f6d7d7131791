package callsites;

import java.util.Optional;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.ClassNode;

/**
 * What a class beside another, in its package and its nest, may use. It may use less than the other where that one
 * inherits from a class of another package.
 */
record Access(ClassIndex index, ClassNode host) {

  static String nestOf(ClassNode type) {
    return type.nestHostClass == null ? type.name : type.nestHostClass;
  }

  boolean mayUse(Type type) {
    return switch (type.getSort()) {
      case Type.ARRAY -> mayUse(type.getElementType());
      case Type.OBJECT -> index.find(type.getInternalName())
          .filter(found -> is(found.access, Opcodes.ACC_PUBLIC) || isNear(found)).isPresent();
      default -> true;
    };
  }

  boolean mayCall(Handle method) {
    if (method.getOwner().startsWith("[") || !mayUse(Type.getObjectType(method.getOwner()))) {
      return false;
    }
    Optional<ClassIndex.Declared> found = index.declared(method.getOwner(), method.getName(), method.getDesc());
    return found.filter(declared -> mayCall(method, declared)).isPresent();
  }

  private boolean mayCall(Handle method, ClassIndex.Declared declared) {
    int access = declared.method().access;
    boolean own = is(access, Opcodes.ACC_PRIVATE);
    if (declared.type().name.startsWith("java/lang/invoke/") || method.getTag() == Opcodes.H_INVOKESPECIAL && !own) {
      return false; // signatures that the virtual machine makes up, and calls of super
    }
    if (own) {
      return nestOf(declared.type()).equals(nestOf(host));
    }
    return is(access, Opcodes.ACC_PUBLIC) || isNear(declared.type());
  }

  private boolean isNear(ClassNode other) {
    return packageOf(other.name).equals(packageOf(host.name));
  }

  private static String packageOf(String name) {
    return name.substring(0, name.lastIndexOf('/') + 1);
  }

  private static boolean is(int access, int flag) {
    return (access & flag) != 0;
  }
}
