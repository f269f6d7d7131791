/** How the bytes of messages become values and back, by the encodings that servers name. */
package org.robotui.rfic.foxglove.internal.payload;
