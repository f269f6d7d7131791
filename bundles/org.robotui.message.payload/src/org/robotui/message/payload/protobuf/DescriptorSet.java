package org.robotui.message.payload.protobuf;

import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.DescriptorValidationException;
import com.google.protobuf.Descriptors.FileDescriptor;
import com.google.protobuf.DurationProto;
import com.google.protobuf.InvalidProtocolBufferException;
import com.google.protobuf.TimestampProto;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Finds the descriptor of a type in a set of files, which a server sends. What it sends is bounded and not trusted. */
public final class DescriptorSet {
  private static final int LONGEST = 1 << 22;
  private static final int MOST_FILES = 1000;

  private final Map<String, FileDescriptorProto> files = new HashMap<>();
  private final Map<String, FileDescriptor> built = new HashMap<>();
  private final Set<String> open = new HashSet<>();

  private DescriptorSet(FileDescriptorSet set) {
    set.getFileList().forEach(file -> files.put(file.getName(), file));
    List.of(TimestampProto.getDescriptor(), DurationProto.getDescriptor())
        .forEach(known -> built.put(known.getName(), known));
  }

  /**
   * The descriptor of a type.
   *
   * @param base64 a {@code FileDescriptorSet}
   * @param type the full name
   * @return the descriptor
   * @throws IllegalArgumentException where there is none; says why
   */
  public static Descriptor message(String base64, String type) {
    if (base64.length() > LONGEST) {
      throw new IllegalArgumentException("the descriptors of " + base64.length() + " characters are too long");
    }
    try {
      FileDescriptorSet set = FileDescriptorSet.parseFrom(Base64.getDecoder().decode(base64));
      if (set.getFileCount() > MOST_FILES) {
        throw new IllegalArgumentException(set.getFileCount() + " files of descriptors are too many");
      }
      return new DescriptorSet(set).find(type)
          .orElseThrow(() -> new IllegalArgumentException("the descriptors that came do not have the type"));
    } catch (InvalidProtocolBufferException | DescriptorValidationException e) {
      throw new IllegalArgumentException("its descriptors cannot be read: " + e.getMessage(), e);
    }
  }

  /**
   * The files that a type needs.
   *
   * @param type the type
   * @return a {@code FileDescriptorSet}, of which no file needs another one that is not in it
   */
  public static byte[] of(Descriptor type) {
    Map<String, FileDescriptor> needed = new LinkedHashMap<>();
    gather(type.getFile(), needed);
    return FileDescriptorSet.newBuilder().addAllFile(needed.values().stream().map(FileDescriptor::toProto).toList())
        .build().toByteArray();
  }

  private static void gather(FileDescriptor file, Map<String, FileDescriptor> needed) {
    if (!needed.containsKey(file.getName())) {
      file.getDependencies().forEach(each -> gather(each, needed));
      needed.put(file.getName(), file);
    }
  }

  private Optional<Descriptor> find(String type) throws DescriptorValidationException {
    for (String name : List.copyOf(files.keySet())) {
      Optional<Descriptor> found = find(file(name).getMessageTypes(), type);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private static Optional<Descriptor> find(List<Descriptor> among, String type) {
    for (Descriptor each : among) {
      if (each.getFullName().equals(type)) {
        return Optional.of(each);
      }
      if (type.startsWith(each.getFullName() + ".")) {
        return find(each.getNestedTypes(), type);
      }
    }
    return Optional.empty();
  }

  private FileDescriptor file(String name) throws DescriptorValidationException {
    FileDescriptor known = built.get(name);
    if (known != null) {
      return known;
    }
    if (!open.add(name)) {
      throw new IllegalArgumentException("the file of descriptors " + name + " needs itself");
    }
    FileDescriptorProto file = files.get(name);
    List<FileDescriptor> needed = new ArrayList<>();
    for (String each : file.getDependencyList()) {
      if (files.containsKey(each) || built.containsKey(each)) {
        needed.add(file(each));
      }
    }
    FileDescriptor made = built(file, needed.toArray(FileDescriptor[]::new));
    built.put(name, made);
    return made;
  }

  /** Of files that are wrong in a way which it does not check for, the library throws what it happens to meet. */
  private static FileDescriptor built(FileDescriptorProto file, FileDescriptor... needed)
      throws DescriptorValidationException {
    try {
      return FileDescriptor.buildFrom(file, needed, true);
    } catch (RuntimeException e) {
      throw new IllegalArgumentException("its descriptors cannot be used: " + e.getMessage(), e);
    }
  }
}
