package org.robotui.rfic.foxglove.internal;

import com.google.protobuf.DescriptorProtos.DescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Label;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Type;
import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.TimestampProto;
import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.robotui.message.payload.protobuf.DescriptorSet;
import org.robotui.message.payload.protobuf.ProtobufMessages;

/** A scan of Protocol Buffers, with the numbers of fields that the published schema has. */
final class ProtobufScan {
  static final String TYPE = "foxglove.LaserScan";
  static final String DESCRIPTORS = Base64.getEncoder().encodeToString(files().toByteArray());

  private ProtobufScan() {}

  private static FileDescriptorSet files() {
    DescriptorProto scan = DescriptorProto.newBuilder().setName("LaserScan")
        .addField(field(1, "timestamp", Type.TYPE_MESSAGE, Label.LABEL_OPTIONAL)
            .setTypeName(".google.protobuf.Timestamp"))
        .addField(field(2, "frame_id", Type.TYPE_STRING, Label.LABEL_OPTIONAL))
        .addField(field(4, "start_angle", Type.TYPE_DOUBLE, Label.LABEL_OPTIONAL))
        .addField(field(5, "end_angle", Type.TYPE_DOUBLE, Label.LABEL_OPTIONAL))
        .addField(field(6, "ranges", Type.TYPE_DOUBLE, Label.LABEL_REPEATED))
        .addField(field(7, "intensities", Type.TYPE_DOUBLE, Label.LABEL_REPEATED)).build();
    FileDescriptorProto file = FileDescriptorProto.newBuilder().setName("foxglove/LaserScan.proto")
        .setPackage("foxglove").setSyntax("proto3").addDependency("google/protobuf/timestamp.proto")
        .addMessageType(scan).build();
    return FileDescriptorSet.newBuilder().addFile(file).addFile(TimestampProto.getDescriptor().toProto()).build();
  }

  private static FieldDescriptorProto.Builder field(int number, String name, Type type, Label label) {
    return FieldDescriptorProto.newBuilder().setNumber(number).setName(name).setType(type).setLabel(label);
  }

  static Descriptor descriptor() {
    return DescriptorSet.message(DESCRIPTORS, TYPE);
  }

  static ByteBuffer message(String frame, long nanos, double start, double end, double... ranges) {
    Map<String, Object> fields = new LinkedHashMap<>(Map.of("timestamp", nanos, "frame_id", frame, "start_angle",
        start, "end_angle", end));
    fields.put("ranges", DoubleStream.of(ranges).boxed().toList());
    fields.put("intensities", List.of());
    return ProtobufMessages.write(descriptor(), fields);
  }
}
