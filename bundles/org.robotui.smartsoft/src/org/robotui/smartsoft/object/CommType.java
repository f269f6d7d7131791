package org.robotui.smartsoft.object;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;

/**
 * A type of communication objects. Immutable.
 *
 * @param name as SmartSoft writes it, such as {@code CommBasicObjects::CommPose3d}
 * @param schema its fields
 */
public record CommType(String name, MessageSchema schema) {

  /**
   * Reads an object.
   *
   * @param object all of its bytes, in their order
   * @return the object
   * @throws MessageException where they are no object of this type
   */
  public DynamicMessage read(ByteBuffer object) throws MessageException {
    return DynamicMessage.read(schema, new CdrReader(object, object.order()));
  }

  /**
   * Writes an object.
   *
   * @param object of this type
   * @param order of the bytes
   * @return its bytes, in their order
   */
  public ByteBuffer write(DynamicMessage object, ByteOrder order) {
    CdrWriter out = CdrWriter.plain(order);
    object.write(out);
    return out.view();
  }

  /**
   * Makes an object of values.
   *
   * @param values by the names of fields, as {@link DynamicCodec#build} takes them; what is not given is zero or empty
   * @return the object
   * @throws MessageException where a value does not fit its field, or there is no such field
   */
  public DynamicMessage make(Map<String, ?> values) throws MessageException {
    return new DynamicCodec(schema).build(values);
  }

  /**
   * Makes the bytes of an object.
   *
   * @param values by the names of fields
   * @return its bytes, little endian, as clients and servers send them
   * @throws MessageException where a value does not fit its field, or there is no such field
   */
  public ByteBuffer bytes(Map<String, ?> values) throws MessageException {
    return write(make(values), ByteOrder.LITTLE_ENDIAN);
  }
}
