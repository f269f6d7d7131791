/** What users ask of a server: services, parameters, what there is. */
package org.robotui.rfic.foxglove.internal.call;
