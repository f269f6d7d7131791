/** The messages of the protocol. */
package org.robotui.foxglove.internal;
