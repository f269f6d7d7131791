package org.robotui.gazebo.types;

import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** The types that are known here, of no package. */
final class ShippedTypes {
  static final FileDescriptorProto FILE = read();

  private ShippedTypes() {}

  private static FileDescriptorProto read() {
    try (InputStream in = Objects.requireNonNull(ShippedTypes.class.getResourceAsStream("messages.proto"))) {
      return FileDescriptorProto.newBuilder(ProtoReader.read(new String(in.readAllBytes(), StandardCharsets.UTF_8)))
          .setName("messages.proto").build();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
