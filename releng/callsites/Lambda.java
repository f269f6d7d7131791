package callsites;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;

/**
 * A lambda or method reference, as its call site describes it to {@link java.lang.invoke.LambdaMetafactory}.
 *
 * @param name the method of the interface
 * @param signatures how that method is called: without type parameters, and as its bridges
 * @param concrete the same with type arguments
 * @param factory takes what is captured, and returns the interface
 * @param body what is called
 */
record Lambda(String name, List<Type> signatures, Type concrete, Type factory, Handle body) {
  private static final String METAFACTORY = "java/lang/invoke/LambdaMetafactory";

  private static final int BRIDGES = 4; // LambdaMetafactory.FLAG_BRIDGES

  /** Empty for what is no lambda, and for those that can be serialized or implement further interfaces. */
  static Optional<Lambda> of(InvokeDynamicInsnNode site) {
    if (!site.bsm.getOwner().equals(METAFACTORY)) {
      return Optional.empty();
    }
    Object[] arguments = site.bsmArgs;
    List<Type> signatures = new ArrayList<>(List.of((Type) arguments[0]));
    if (site.bsm.getName().equals("altMetafactory")) {
      int flags = (Integer) arguments[3];
      if ((flags & ~BRIDGES) != 0) {
        return Optional.empty();
      }
      if (flags == BRIDGES) {
        Stream.of(arguments).skip(5).map(Type.class::cast).forEach(signatures::add);
      }
    }
    Lambda lambda = new Lambda(site.name, signatures.stream().distinct().toList(), (Type) arguments[2],
        Type.getMethodType(site.desc), (Handle) arguments[1]);
    return Optional.of(lambda).filter(Lambda::isConvertible);
  }

  Type type() {
    return factory.getReturnType();
  }

  Type[] captured() {
    return factory.getArgumentTypes();
  }

  /** What the body takes, its receiver included. */
  List<Type> taken() {
    Stream<Type> receiver = hasReceiver() ? Stream.of(Type.getObjectType(body.getOwner())) : Stream.empty();
    return Stream.concat(receiver, Stream.of(Type.getArgumentTypes(body.getDesc()))).toList();
  }

  Type given() {
    return isConstructor() ? Type.getObjectType(body.getOwner()) : Type.getReturnType(body.getDesc());
  }

  boolean isConstructor() {
    return body.getTag() == Opcodes.H_NEWINVOKESPECIAL;
  }

  /** Whether a class that may use no more than this may be what the call site makes. */
  boolean isWithin(Access access) {
    Stream<Type> types = Stream.of(captured(), concrete.getArgumentTypes()).flatMap(Stream::of);
    Stream<Type> others = Stream.of(type(), given(), concrete.getReturnType());
    return access.mayCall(body)
        && Stream.of(types, others, taken().stream(), signatures.stream().map(Type::getReturnType))
            .flatMap(all -> all).allMatch(access::mayUse);
  }

  private boolean hasReceiver() {
    return !isConstructor() && body.getTag() != Opcodes.H_INVOKESTATIC;
  }

  private boolean isConvertible() {
    List<Type> from = new ArrayList<>(List.of(captured()));
    from.addAll(List.of(concrete.getArgumentTypes()));
    List<Type> to = taken();
    for (int i = 0; i < to.size(); i++) {
      if (!Conversion.isPossible(from.get(i), to.get(i))) {
        return false;
      }
    }
    return Conversion.isPossible(given(), concrete.getReturnType());
  }
}
