package org.robotui.gazebo.types;

import com.google.protobuf.AnyProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.DescriptorValidationException;
import com.google.protobuf.Descriptors.FileDescriptor;
import com.google.protobuf.DurationProto;
import com.google.protobuf.TimestampProto;
import com.google.protobuf.WrappersProto;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Types of messages by their names. Those of {@code gz.msgs} and of {@code ignition.msgs}, as older releases call the
 * same types, are known here as far as robots need them; others are looked for in files. Safe for all threads.
 */
public final class GazeboTypes {
  private static final Logger LOG = LoggerFactory.getLogger(GazeboTypes.class);
  private static final Set<String> PACKAGES = Set.of("gz.msgs", "ignition.msgs");
  private static final FileDescriptor[] STANDARD = {AnyProto.getDescriptor(), DurationProto.getDescriptor(),
      TimestampProto.getDescriptor(), WrappersProto.getDescriptor()};

  private final TypeFiles files;
  private final Map<String, Optional<FileDescriptor>> known = new HashMap<>();
  private final Map<String, Optional<FileDescriptor>> found = new HashMap<>();

  private GazeboTypes(TypeFiles files) {
    this.files = files;
  }

  /**
   * With the files of the search path, which are read when they are needed.
   *
   * @param variables those of the environment: {@code GZ_DESCRIPTOR_PATH} and {@code IGN_DESCRIPTOR_PATH} name folders
   * and files, with colons between them
   * @return the types
   */
  public static GazeboTypes of(Map<String, String> variables) {
    return new GazeboTypes(TypeFiles.of(variables));
  }

  /**
   * The type of a name.
   *
   * @param name in full, such as {@code gz.msgs.Twist}
   * @return its descriptor, or none where it is not known
   */
  public synchronized Optional<Descriptor> find(String name) {
    String prefix = name.substring(0, Math.max(0, name.lastIndexOf('.')));
    return in(known.computeIfAbsent(prefix, this::shipped), name)
        .or(() -> in(found.computeIfAbsent(prefix, this::installed), name));
  }

  private static Optional<Descriptor> in(Optional<FileDescriptor> file, String name) {
    return file
        .flatMap(all -> Optional.ofNullable(all.findMessageTypeByName(name.substring(name.lastIndexOf('.') + 1))));
  }

  private Optional<FileDescriptor> shipped(String prefix) {
    return PACKAGES.contains(prefix)
        ? built(FileDescriptorProto.newBuilder(ShippedTypes.FILE).setPackage(prefix).build())
        : Optional.empty();
  }

  private Optional<FileDescriptor> installed(String prefix) {
    return files.all(prefix).flatMap(GazeboTypes::built);
  }

  private static Optional<FileDescriptor> built(FileDescriptorProto file) {
    try {
      return Optional.of(FileDescriptor.buildFrom(file, STANDARD, true));
    } catch (DescriptorValidationException | RuntimeException e) {
      LOG.warn("the types of {} cannot be used: {}", file.getPackage(), e.getMessage());
      return Optional.empty();
    }
  }

  /** Where types are looked for that are not known here, for users. */
  public List<String> searched() {
    return files.searched();
  }
}
