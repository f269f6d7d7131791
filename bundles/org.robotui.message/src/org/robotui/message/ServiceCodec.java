package org.robotui.message;

import java.util.Objects;

/**
 * The identity and the two codecs of a service type.
 *
 * @param type the service type's full name, such as {@code std_srvs/SetBool}
 * @param md5 the MD5 sum of the whole service definition as ROS computes it, or {@code *} for any
 * @param request the codec of the request
 * @param response the codec of the response
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public record ServiceCodec<Q, R>(String type, String md5, MessageCodec<Q> request, MessageCodec<R> response) {

  /** Checks that nothing is missing. */
  public ServiceCodec {
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(md5, "md5");
    Objects.requireNonNull(request, "request");
    Objects.requireNonNull(response, "response");
  }
}
