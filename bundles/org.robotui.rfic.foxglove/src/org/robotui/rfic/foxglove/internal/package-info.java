/** Robots behind servers that speak Foxglove's WebSocket protocol. */
package org.robotui.rfic.foxglove.internal;
