package org.robotui.lcm.type;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The numbers by which encoders and decoders know that they mean the same type.
 *
 * <p>Source: "Fingerprint Computation" in the "LCM Type Specification Language" of LCM's documentation. A type has a
 * base of its own: a hash of the names, built-in types and sizes of its members, not of its own name. Its fingerprint
 * is the sum of the base and the fingerprints of the structs it holds, rotated left by one bit. In that sum a type that
 * is being computed already counts as zero, so that recursive types have an end.
 */
final class Fingerprints {

  private static final long STRUCT = 0x12345678L;
  private static final long ENUMERATION = 0x87654321L;
  private static final int MOST_STEPS = 10_000;

  private final Map<String, TypeDefinition> types;
  private final Map<String, Long> known = new HashMap<>();
  private final Set<String> open = new LinkedHashSet<>();
  private int steps;

  Fingerprints(Map<String, TypeDefinition> types) {
    this.types = types;
  }

  /** The fingerprint of a struct all of whose types are known. */
  long of(TypeDefinition.Struct struct) throws TypeException {
    steps = 0;
    open.clear();
    return sum(struct).value();
  }

  /** A sum, and whether it is the same wherever the type stands. */
  private record Sum(long value, boolean everywhere) {}

  private Sum sum(TypeDefinition type) throws TypeException {
    return switch (type) {
      case TypeDefinition.Enumeration enumeration -> new Sum(base(enumeration), true);
      case TypeDefinition.Struct struct -> {
        Long value = known.get(struct.name());
        yield value != null ? new Sum(value, true) : open.contains(struct.name()) ? new Sum(0, false) : walk(struct);
      }
    };
  }

  private Sum walk(TypeDefinition.Struct struct) throws TypeException {
    if (++steps > MOST_STEPS) {
      throw new TypeException(struct.place(), "this type and those it holds are interwoven too much for a fingerprint",
          "have fewer types hold each other");
    }
    open.add(struct.name());
    long total = base(struct);
    boolean everywhere = true;
    for (MemberDefinition member : struct.members()) {
      if (Primitive.of(member.type()).isEmpty()) {
        Sum part = sum(types.get(member.type()));
        total += part.value();
        everywhere &= part.everywhere();
      }
    }
    open.remove(struct.name());
    long value = Long.rotateLeft(total, 1);
    if (everywhere) {
      known.put(struct.name(), value);
    }
    return new Sum(value, everywhere);
  }

  private static long base(TypeDefinition.Enumeration enumeration) {
    String name = enumeration.name();
    return text(ENUMERATION, name.substring(name.lastIndexOf('.') + 1));
  }

  static long base(TypeDefinition.Struct struct) {
    long hash = STRUCT;
    for (MemberDefinition member : struct.members()) {
      hash = text(hash, member.name());
      if (Primitive.of(member.type()).isPresent()) {
        hash = text(hash, member.type());
      }
      hash = dimensions(hash, member.dimensions());
    }
    return hash;
  }

  private static long dimensions(long start, List<Dimension> dimensions) {
    long hash = one(start, dimensions.size());
    for (Dimension dimension : dimensions) {
      hash = one(hash, dimension instanceof Dimension.Variable ? 1 : 0);
      hash = text(hash, dimension.text());
    }
    return hash;
  }

  private static long text(long start, String text) {
    long hash = one(start, text.length());
    for (int i = 0; i < text.length(); i++) {
      hash = one(hash, text.charAt(i));
    }
    return hash;
  }

  /** The value is a signed byte, as it is where the fingerprints of all others come from. */
  private static long one(long hash, int value) {
    return ((hash << 8) ^ (hash >> 55)) + (byte) value;
  }
}
