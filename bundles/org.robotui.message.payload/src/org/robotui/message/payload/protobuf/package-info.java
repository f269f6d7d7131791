/** Messages of Protocol Buffers by the descriptors that come with them. */
package org.robotui.message.payload.protobuf;
