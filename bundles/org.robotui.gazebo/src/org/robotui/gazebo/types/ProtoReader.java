package org.robotui.gazebo.types;

import com.google.protobuf.DescriptorProtos.DescriptorProto;
import com.google.protobuf.DescriptorProtos.EnumDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Label;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Type;
import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.MessageOptions;
import com.google.protobuf.DescriptorProtos.OneofDescriptorProto;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Reads definitions in the language of Protocol Buffers (proto3): packages, messages, enumerations, maps and oneofs.
 * Options, services and what is reserved are passed over. Names of types stay as they are written.
 */
final class ProtoReader {
  private static final int DEEPEST = 20;
  private static final Set<String> SCALARS = Set.of("double", "float", "int64", "uint64", "int32", "fixed64", "fixed32",
      "bool", "string", "bytes", "uint32", "sfixed32", "sfixed64", "sint32", "sint64");
  private static final Set<String> PASSED = Set.of("option", "reserved", "extensions", "extend", "group");

  private final ProtoTokens in;

  private ProtoReader(String text) {
    this.in = new ProtoTokens(text);
  }

  /**
   * Reads a file.
   *
   * @throws IllegalArgumentException where the text is no definition; says why
   */
  static FileDescriptorProto read(String text) {
    return new ProtoReader(text).file();
  }

  private FileDescriptorProto file() {
    FileDescriptorProto.Builder file = FileDescriptorProto.newBuilder().setSyntax("proto3");
    while (!in.peek().isEmpty()) {
      if (in.accept("message")) {
        file.addMessageType(message(0));
      } else if (in.accept("enum")) {
        file.addEnumType(enumeration());
      } else if (in.accept("package")) {
        file.setPackage(in.next());
        in.expect(";");
      } else if (!in.accept(";")) {
        in.skip();
      }
    }
    return file.build();
  }

  private DescriptorProto message(int depth) {
    if (depth > DEEPEST) {
      throw new IllegalArgumentException("messages within messages are more than " + DEEPEST + " deep");
    }
    DescriptorProto.Builder message = DescriptorProto.newBuilder().setName(in.next());
    in.expect("{");
    while (!in.accept("}")) {
      if (in.accept("message")) {
        message.addNestedType(message(depth + 1));
      } else if (in.accept("enum")) {
        message.addEnumType(enumeration());
      } else if (in.accept("oneof")) {
        oneof(message);
      } else if (PASSED.contains(in.peek())) {
        in.skip();
      } else if (!in.accept(";")) {
        field(message, OptionalInt.empty());
      }
    }
    return message.build();
  }

  private void oneof(DescriptorProto.Builder message) {
    int index = message.getOneofDeclCount();
    message.addOneofDecl(OneofDescriptorProto.newBuilder().setName(in.next()));
    in.expect("{");
    while (!in.accept("}")) {
      if (in.peek().equals("option")) {
        in.skip();
      } else if (!in.accept(";")) {
        field(message, OptionalInt.of(index));
      }
    }
  }

  private void field(DescriptorProto.Builder message, OptionalInt oneof) {
    boolean repeated = in.accept("repeated");
    if (!repeated) {
      in.accept("optional");
    }
    String type = in.next();
    if (type.equals("map") && in.accept("<")) {
      map(message);
      return;
    }
    FieldDescriptorProto.Builder field = field(in.next(), type, repeated);
    oneof.ifPresent(field::setOneofIndex);
    message.addField(field);
    end();
  }

  private FieldDescriptorProto.Builder field(String name, String type, boolean repeated) {
    in.expect("=");
    return typed(name, type).setNumber(in.number())
        .setLabel(repeated ? Label.LABEL_REPEATED : Label.LABEL_OPTIONAL);
  }

  private static FieldDescriptorProto.Builder typed(String name, String type) {
    FieldDescriptorProto.Builder field = FieldDescriptorProto.newBuilder().setName(name);
    return SCALARS.contains(type) ? field.setType(Type.valueOf("TYPE_" + type.toUpperCase(Locale.ROOT)))
        : field.setTypeName(type);
  }

  /** A map is sent as a list of pairs, which have a type of their own. */
  private void map(DescriptorProto.Builder message) {
    String key = in.next();
    in.expect(",");
    String value = in.next();
    in.expect(">");
    String name = in.next();
    String pair = name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1).replace("_", "") + "Entry";
    message.addNestedType(DescriptorProto.newBuilder().setName(pair)
        .setOptions(MessageOptions.newBuilder().setMapEntry(true))
        .addField(typed("key", key).setNumber(1).setLabel(Label.LABEL_OPTIONAL))
        .addField(typed("value", value).setNumber(2).setLabel(Label.LABEL_OPTIONAL)));
    message.addField(field(name, pair, true));
    end();
  }

  private EnumDescriptorProto enumeration() {
    EnumDescriptorProto.Builder words = EnumDescriptorProto.newBuilder().setName(in.next());
    in.expect("{");
    while (!in.accept("}")) {
      if (in.peek().equals("option") || in.peek().equals("reserved")) {
        if (in.peek().equals("option") && in.peekAfter().equals("allow_alias")) {
          words.getOptionsBuilder().setAllowAlias(true);
        }
        in.skip();
      } else if (!in.accept(";")) {
        word(words);
      }
    }
    return words.build();
  }

  private void word(EnumDescriptorProto.Builder words) {
    String name = in.next();
    in.expect("=");
    int sign = in.accept("-") ? -1 : 1;
    words.addValueBuilder().setName(name).setNumber(sign * in.number());
    end();
  }

  /** The end of a statement, with options in brackets. */
  private void end() {
    if (in.peek().equals("[")) {
      in.skip();
    } else {
      in.expect(";");
    }
  }
}
