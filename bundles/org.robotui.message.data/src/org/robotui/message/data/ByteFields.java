package org.robotui.message.data;

import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/** A record that gives fields of many bytes, such as images, without making a number of each. */
public interface ByteFields extends DynamicRecord {

  /**
   * The bytes of a field.
   *
   * @param name one of {@link #fields()}
   * @return its bytes, or none where there is no such field, or it holds something else
   */
  @Override
  Optional<Bytes> bytes(String name);
}
