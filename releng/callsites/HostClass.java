package callsites;

import java.util.List;
import java.util.Optional;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/** A class whose call sites are linked. */
final class HostClass {
  private final ClassNode type;

  private final Access access;

  private int lambdas;

  HostClass(ClassNode type, Access access) {
    this.type = type;
    this.access = access;
  }

  /** Whether anything was to be linked. */
  boolean link(Added added) {
    boolean changed = false;
    if (type.version < Opcodes.V11) {
      return changed; // there are no nests
    }
    for (MethodNode method : List.copyOf(type.methods)) {
      for (AbstractInsnNode instruction : method.instructions.toArray()) {
        Optional<MethodInsnNode> call = instruction instanceof InvokeDynamicInsnNode site
            ? instead(site, added)
            : Optional.empty();
        if (call.isPresent()) {
          method.instructions.set(instruction, call.get());
          changed = true;
        }
      }
    }
    return changed;
  }

  private Optional<MethodInsnNode> instead(InvokeDynamicInsnNode site, Added added) {
    return Lambda.of(site).filter(lambda -> lambda.isWithin(access)).map(lambda -> instead(site, lambda, added))
        .or(() -> new PlainMethods(type).instead(site));
  }

  private MethodInsnNode instead(InvokeDynamicInsnNode site, Lambda lambda, Added added) {
    String name = type.name + "$$Lambda" + ++lambdas;
    added.add(type, name, LambdaClass.write(name, lambda, type));
    return new MethodInsnNode(Opcodes.INVOKESTATIC, name, LambdaClass.FACTORY, site.desc, false);
  }

  /** Takes classes that are new in the nest of a host. */
  interface Added {
    void add(ClassNode host, String name, byte[] content);
  }
}
