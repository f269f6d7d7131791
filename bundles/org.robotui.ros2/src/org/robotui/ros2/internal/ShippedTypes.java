package org.robotui.ros2.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.message.Definitions;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;

/** The types that are part of this library, whatever is installed. */
public final class ShippedTypes {

  private static final Definitions NOTHING = new LocalDefinitions(List.of(), List.of(), Generation.ROS2);
  private static final TypeRegistry SHIPPED = new TypeRegistry(NOTHING);

  private ShippedTypes() {}

  /**
   * The whole name of a type that a record is made for.
   *
   * @param plain such as {@code std_msgs/String} or {@code std_srvs/SetBoolRequest}
   * @return such as {@code std_srvs/srv/SetBool_Request}
   */
  public static TypeName name(String plain) {
    TypeName message = TypeName.parse(plain, TypeName.Kind.MSG)
        .orElseThrow(() -> new IllegalArgumentException("'" + plain + "' is no name of a type"));
    return part(message, "Request").or(() -> part(message, "Response")).orElse(message);
  }

  private static Optional<TypeName> part(TypeName message, String part) {
    String name = message.name();
    if (!name.endsWith(part) || name.length() == part.length()) {
      return Optional.empty();
    }
    TypeName service = new TypeName(message.packageName(), TypeName.Kind.SRV,
        name.substring(0, name.length() - part.length()));
    return SHIPPED.service(service, Optional.empty()) instanceof SchemaLookup.Found ? Optional.of(service.part(part))
        : Optional.empty();
  }

  /**
   * The sum of a shipped message.
   *
   * @param name its name
   * @return empty if it is not shipped
   */
  public static Optional<TypeHash> hash(TypeName name) {
    return SHIPPED.message(name, Optional.empty()) instanceof SchemaLookup.Found<MessageSchema> found
        ? Optional.of(TypeDescription.of(name, found.schema()).hash())
        : Optional.empty();
  }

  /**
   * A shipped service.
   *
   * @param name its name
   * @return the type
   * @throws IllegalArgumentException if it is not shipped
   */
  public static ServiceSchema service(TypeName name) {
    return switch (SHIPPED.service(name, Optional.empty())) {
      case SchemaLookup.Found<ServiceSchema> found -> found.schema();
      case SchemaLookup.Missing<ServiceSchema> missing -> throw new IllegalArgumentException(missing.reason());
    };
  }
}
