package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;

/** All types that are known. What is broken is told, and the rest can be used. Immutable. */
public final class TypeLibrary {

  private final SequencedMap<String, LcmType> types = new LinkedHashMap<>();
  private final Map<Long, List<LcmType>> byFingerprint = new LinkedHashMap<>();
  private final List<TypeException> problems = new ArrayList<>();

  private TypeLibrary() {}

  /**
   * Puts types together.
   *
   * @param definitions what was read
   * @param problems what could not be read
   * @return the library, with further problems where a type refers to one that is missing
   */
  public static TypeLibrary of(List<TypeDefinition> definitions, List<TypeException> problems) {
    TypeLibrary library = new TypeLibrary();
    library.problems.addAll(problems);
    Map<String, TypeDefinition> unique = library.unique(definitions);
    Fingerprints fingerprints = new Fingerprints(unique);
    for (TypeDefinition each : unique.values()) {
      if (each instanceof TypeDefinition.Struct struct) {
        library.add(struct, unique, fingerprints);
      }
    }
    return library;
  }

  private Map<String, TypeDefinition> unique(List<TypeDefinition> definitions) {
    Map<String, TypeDefinition> unique = new LinkedHashMap<>();
    for (TypeDefinition each : definitions) {
      TypeDefinition before = unique.putIfAbsent(each.name(), each);
      if (before != null && !sameText(before, each)) {
        problems.add(
            new TypeException(each.place(), "the type '" + each.name() + "' is declared otherwise at " + before.place(),
                "remove one of the two; the first counts"));
      }
    }
    return unique;
  }

  private static boolean sameText(TypeDefinition one, TypeDefinition other) {
    return one instanceof TypeDefinition.Struct first && other instanceof TypeDefinition.Struct second
        ? first.members().toString().equals(second.members().toString()) && first.constants().equals(second.constants())
        : one.getClass() == other.getClass() && one.constants().equals(other.constants());
  }

  private void add(TypeDefinition.Struct struct, Map<String, TypeDefinition> all, Fingerprints fingerprints) {
    try {
      LcmType type = new LcmType(LayoutCompiler.compile(struct, all), fingerprints.of(struct));
      types.put(type.name(), type);
      byFingerprint.computeIfAbsent(type.fingerprint(), fingerprint -> new ArrayList<>()).add(type);
    } catch (TypeException e) {
      problems.add(e);
    }
  }

  /**
   * The types that can be used.
   *
   * @return in the order of their files
   */
  public List<LcmType> types() {
    return List.copyOf(types.values());
  }

  /**
   * What is wrong with the files.
   *
   * @return each with its place and a remedy
   */
  public List<TypeException> problems() {
    return List.copyOf(problems);
  }

  /**
   * A type by its name.
   *
   * @param name the full name
   * @return empty if it is unknown, or cannot be used
   */
  public Optional<LcmType> type(String name) {
    return Optional.ofNullable(types.get(name));
  }

  /**
   * The types with a fingerprint. Those that differ in nothing but their names share one.
   *
   * @param fingerprint the number
   * @return in the order of their files, empty if there is none
   */
  public List<LcmType> withFingerprint(long fingerprint) {
    return List.copyOf(byFingerprint.getOrDefault(fingerprint, List.of()));
  }

  /**
   * Decodes a message by its fingerprint.
   *
   * @param message the bytes, from position to limit; numbers arrays of the record are views of them
   * @return the record, of the first type with this fingerprint
   * @throws RecordException if no type has this fingerprint, or the bytes are damaged
   */
  public LcmRecord decode(ByteBuffer message) throws RecordException {
    long fingerprint = LcmType.fingerprintOf(message);
    return withFingerprint(fingerprint).stream().findFirst()
        .orElseThrow(() -> new RecordException("unknown type", "its fingerprint " + LcmType.hex(fingerprint)
            + " is that of none of the " + types.size() + " known types", "", 0))
        .decode(message);
  }
}
