package org.robotui.ros2;

import java.util.Objects;
import java.util.Optional;
import org.robotui.message.DynamicMessage;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.internal.ShippedTypes;

/**
 * The identity and the two codecs of a type of services.
 *
 * @param type the service's name of three parts
 * @param hash the sum of the whole service, if it is known
 * @param request the codec of the request
 * @param response the codec of the response
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public record Ros2ServiceCodec<Q, R>(TypeName type, Optional<TypeHash> hash, Ros2Codec<Q> request,
    Ros2Codec<R> response) {

  /** Checks that nothing is missing. */
  public Ros2ServiceCodec {
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(hash, "hash");
    Objects.requireNonNull(request, "request");
    Objects.requireNonNull(response, "response");
  }

  /**
   * The codec of a shipped service.
   *
   * @param type its name, such as {@code std_srvs/srv/SetBool}
   * @param request a record of the request
   * @param response a record of the response
   * @param <Q> the record of the request
   * @param <R> the record of the response
   * @return the codec
   * @throws IllegalArgumentException if it is not shipped, or a record does not fit
   */
  public static <Q extends Record, R extends Record> Ros2ServiceCodec<Q, R> of(String type, Class<Q> request,
      Class<R> response) {
    TypeName name = TypeName.parse(type, TypeName.Kind.SRV)
        .orElseThrow(() -> new IllegalArgumentException("'" + type + "' is no name of a service"));
    TypeHash hash = TypeDescription.of(name, ShippedTypes.service(name)).hash();
    return new Ros2ServiceCodec<>(name, Optional.of(hash), Ros2Codec.of(request), Ros2Codec.of(response));
  }

  /**
   * The codec of any service whose definition is known.
   *
   * @param name its name, also of the services of an action
   * @param schema the type
   * @return the codec
   */
  public static Ros2ServiceCodec<DynamicMessage, DynamicMessage> of(TypeName name, ServiceSchema schema) {
    return new Ros2ServiceCodec<>(name, Optional.of(TypeDescription.of(name, schema).hash()),
        Ros2Codec.of(name.part("Request"), schema.request()), Ros2Codec.of(name.part("Response"), schema.response()));
  }
}
