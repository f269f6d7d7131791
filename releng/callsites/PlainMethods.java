package callsites;

import java.util.Optional;
import java.util.function.Consumer;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

/** Static methods of a class in place of its call sites that need no class of their own. */
final class PlainMethods {
  private final ClassNode host;

  PlainMethods(ClassNode host) {
    this.host = host;
  }

  /** The call of a method that does what the call site is linked to; the method is new in its class. */
  Optional<MethodInsnNode> instead(InvokeDynamicInsnNode site) {
    return switch (site.bsm.getOwner() + "." + site.bsm.getName()) {
      case "java/lang/runtime/ObjectMethods.bootstrap" -> ofRecord(site);
      case "java/lang/runtime/SwitchBootstraps.typeSwitch" -> TypeSwitch.isPlain(site)
          ? Optional.of(add("typeSwitch", site, code -> TypeSwitch.write(code, site)))
          : Optional.empty();
      default -> Optional.empty();
    };
  }

  private Optional<MethodInsnNode> ofRecord(InvokeDynamicInsnNode site) {
    Handle[] fields = new Handle[site.bsmArgs.length - 2];
    System.arraycopy(site.bsmArgs, 2, fields, 0, fields.length);
    return switch (site.name) {
      case "equals" -> Optional.of(add("equal", site, code -> RecordMethods.writeEquals(code, host.name, fields)));
      case "hashCode" -> Optional.of(add("hash", site, code -> RecordMethods.writeHashCode(code, fields)));
      default -> Optional.empty();
    };
  }

  private MethodInsnNode add(String purpose, InvokeDynamicInsnNode site, Consumer<MethodNode> body) {
    String name = purpose + "$" + host.methods.size();
    MethodNode method = new MethodNode(Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC, name,
        site.desc, null, null);
    body.accept(method);
    method.visitInsn(Type.getReturnType(site.desc).getOpcode(Opcodes.IRETURN));
    host.methods.add(method);
    boolean isInterface = (host.access & Opcodes.ACC_INTERFACE) != 0;
    return new MethodInsnNode(Opcodes.INVOKESTATIC, host.name, name, site.desc, isInterface);
  }
}
