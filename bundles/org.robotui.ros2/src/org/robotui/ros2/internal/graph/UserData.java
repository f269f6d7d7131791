package org.robotui.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.robotui.message.description.TypeHash;

/** What ROS 2 says with its endpoints: {@code key=value;} pairs. */
public final class UserData {

  private static final String HASH = "typehash=";
  private static final int MOST_BYTES = 4096;

  private UserData() {}

  /**
   * The sum of a type.
   *
   * @param userData what was announced
   * @return empty where none was
   */
  public static Optional<TypeHash> hash(ByteBuffer userData) {
    if (userData.remaining() > MOST_BYTES) {
      return Optional.empty();
    }
    String text = StandardCharsets.ISO_8859_1.decode(userData.duplicate()).toString();
    return Arrays.stream(text.split(";")).filter(pair -> pair.startsWith(HASH))
        .flatMap(pair -> TypeHash.parse(pair.substring(HASH.length())).stream()).findFirst();
  }

  /**
   * What is announced.
   *
   * @param hash the sum of the type, if it is known
   * @return the bytes
   */
  public static ByteBuffer of(Optional<TypeHash> hash) {
    return StandardCharsets.UTF_8.encode(hash.map(sum -> HASH + sum.text() + ";").orElse(""));
  }
}
