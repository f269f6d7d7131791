package org.robotui.message;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;

/** Computes the sums by which ROS peers compare types: constants first, nested types replaced by their own sums. */
final class Md5 {

  private final Map<String, MessageDefinition> nested;
  private final Map<String, String> known = new HashMap<>();

  Md5(Map<String, MessageDefinition> nested) {
    this.nested = nested;
  }

  String of(MessageDefinition definition) {
    return digest(text(definition));
  }

  static String ofService(MessageSchema request, MessageSchema response) {
    return digest(new Md5(request.nested()).text(request.definition())
        + new Md5(response.nested()).text(response.definition()));
  }

  private String text(MessageDefinition definition) {
    StringBuilder text = new StringBuilder();
    for (ConstantDefinition each : definition.constants()) {
      text.append(each.type().rosName()).append(' ').append(each.name()).append('=').append(each.value())
          .append('\n');
    }
    for (FieldDefinition each : definition.fields()) {
      text.append(typeText(each.type())).append(' ').append(each.name()).append('\n');
    }
    return text.toString().strip();
  }

  private String typeText(FieldType type) {
    if (type.primitive().isPresent()) {
      return type.toString();
    }
    String sum = known.get(type.base());
    if (sum == null) {
      sum = of(nested.get(type.base()));
      known.put(type.base(), sum);
    }
    return sum;
  }

  private static String digest(String text) {
    try {
      byte[] sum = MessageDigest.getInstance("MD5").digest(text.getBytes(StandardCharsets.UTF_8));
      return HexFormat.of().formatHex(sum);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("this Java runtime has no MD5", e);
    }
  }
}
